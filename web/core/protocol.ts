// The messages between browser and server, as generated from proto/mlab/console*.proto, and how they become bytes.
import { create, fromBinary, type MessageInitShape, toBinary } from "@bufbuild/protobuf";
import { type ToBrowser, ToBrowserSchema, ToServerSchema } from "../generated/mlab/console_pb.ts";

export * from "../generated/mlab/console_bookmarks_pb.ts";
export * from "../generated/mlab/console_futures_pb.ts";
export * from "../generated/mlab/console_machines_pb.ts";
export * from "../generated/mlab/console_map_pb.ts";
export * from "../generated/mlab/console_orders_pb.ts";
export * from "../generated/mlab/console_pb.ts";
export * from "../generated/mlab/console_preflight_pb.ts";
export * from "../generated/mlab/console_state_pb.ts";
export * from "../generated/mlab/console_time_pb.ts";

/** The version that Hello announces. */
export const kProtocol = 1;

/** No step, no program: indices that point nowhere. */
export const kNone = 0xffffffff;

/** What a browser can say: `{ case: "control", value: { action: Control_Action.EXECUTE } }`. */
export type Order = NonNullable<MessageInitShape<typeof ToServerSchema>["body"]>;

export function encodeToServer(request: number, body: Order): Uint8Array<ArrayBuffer> {
  return toBinary(ToServerSchema, create(ToServerSchema, { request, body })) as Uint8Array<ArrayBuffer>;
}

/** Throws on bytes that are no message. */
export function decodeToBrowser(bytes: Uint8Array): ToBrowser {
  return fromBinary(ToBrowserSchema, bytes);
}
