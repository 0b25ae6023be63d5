// The designer's connection to its server.
import { create } from "@bufbuild/protobuf";
import { type LinkOptions, ServerLink, type Speech } from "../../core/server_link.ts";
import { type Answer, AnswerSchema, decode, encode, type FromDesigner, kProtocol, type Request } from "./protocol.ts";

export type Link = ServerLink<Request, FromDesigner, Answer>;

const kSpeech: Speech<Request, FromDesigner, Answer> = {
  encode,
  decode,
  answerIn: ({ body }) => (body.case === "answer" ? body.value : undefined),
  refusal: (request, error) => create(AnswerSchema, { request, ok: false, error }),
  isWelcome: ({ body }) => body.case === "hello",
  beat: (number) => ({ case: "beat", value: { number } }),
  beatIn: ({ body }) => (body.case === "beat" ? body.value.number : undefined),
};

type LinkParts = Omit<LinkOptions<Request, FromDesigner, Answer>, "path" | "speech" | "opened">;

/** Not connected yet. */
export function linkTo(wanted: LinkParts): Link {
  const link: Link = new ServerLink({
    ...wanted,
    path: "designer",
    speech: kSpeech,
    opened: () => link.tell({ case: "greeting", value: { protocol: kProtocol } }),
  });
  return link;
}
