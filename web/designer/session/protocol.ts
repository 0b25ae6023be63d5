// The messages between browser and designer, as generated from proto/mlab/designer*.proto, and how they become bytes.
import { create, fromBinary, type MessageInitShape, toBinary } from "@bufbuild/protobuf";
import type { ChangeSchema } from "../../generated/mlab/designer_changes_pb.ts";
import { type FromDesigner, FromDesignerSchema, ToDesignerSchema } from "../../generated/mlab/designer_pb.ts";

export * from "../../generated/mlab/designer_changes_pb.ts";
export * from "../../generated/mlab/designer_compare_pb.ts";
export * from "../../generated/mlab/designer_drawing_pb.ts";
export * from "../../generated/mlab/designer_pb.ts";
export * from "../../generated/mlab/designer_tests_pb.ts";
export * from "../../generated/mlab/names_pb.ts";

/** The version that Greeting announces. */
export const kProtocol = 1;

/** What the page on which nothing encloses a node calls its value. */
export const kResult = "$result";

/** What a browser can say: `{ case: "undo", value: { document } }`. */
export type Request = NonNullable<MessageInitShape<typeof ToDesignerSchema>["body"]>;

/** One change of an Edit: `{ case: "place", value: { page, component } }`. */
export type ChangeInit = NonNullable<NonNullable<MessageInitShape<typeof ChangeSchema>["change"]>>;

/** What a kind of change says. */
export type ChangeOf<Case extends ChangeInit["case"]> = NonNullable<Extract<ChangeInit, { case: Case }>["value"]>;

export function encode(request: number, body: Request): Uint8Array<ArrayBuffer> {
  return toBinary(ToDesignerSchema, create(ToDesignerSchema, { request, body })) as Uint8Array<ArrayBuffer>;
}

/** Throws on bytes that are no message. */
export function decode(bytes: Uint8Array): FromDesigner {
  return fromBinary(FromDesignerSchema, bytes);
}
