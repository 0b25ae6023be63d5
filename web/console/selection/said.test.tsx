import { create } from "@bufbuild/protobuf";
import { act } from "react";
import { createRoot } from "react-dom/client";
import { expect, it } from "vitest";
import { type Reply, ReplySchema, SaidSchema } from "../../core/protocol.ts";
import { type Session, SessionContext } from "../session/session.ts";
import { SaidThere } from "./said.tsx";

Object.assign(globalThis, { IS_REACT_ACT_ENVIRONMENT: true });

const kSaid = create(ReplySchema, {
  ok: true,
  result: { case: "said", value: create(SaidSchema, { program: "out of memory" }) },
});
const kSilent = create(ReplySchema, { ok: false, error: "the agent on `north` has been silent for 9 s" });

it("what was read stays when the agent can't be asked, and says when that was", async () => {
  const answers: Reply[] = [kSaid, kSilent, kSaid];
  const connection = { ask: () => Promise.resolve(answers.shift()) };
  const place = document.body.appendChild(document.createElement("div"));
  const root = createRoot(place);
  act(() =>
    root.render(
      <SessionContext value={{ connection } as unknown as Session}>
        <SaidThere robot={1} machine="north" />
      </SessionContext>,
    ),
  );
  const read = () => act(async () => place.querySelector("button")?.click());
  await read();
  expect(place.textContent).toContain("out of memory");
  expect(place.textContent).not.toMatch(/was read at/);
  await read();
  expect(place.textContent).toContain("Messages can't be read: the agent on “north” has been silent for 9 s.");
  expect(place.textContent).toMatch(/What follows was read at \d\d:\d\d:\d\d\..*out of memory/);
  await read();
  expect(place.textContent).not.toMatch(/can't be read|was read at/);
  act(() => root.unmount());
  place.remove();
});
