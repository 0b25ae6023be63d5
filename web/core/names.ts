// Messages about the names of a project, as generated from proto/mlab/names.proto: of the console's server and the
// designer's.
export * from "../generated/mlab/names_pb.ts";
