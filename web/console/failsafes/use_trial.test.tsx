import { create } from "@bufbuild/protobuf";
import { act } from "react";
import { createRoot } from "react-dom/client";
import { afterEach, describe, expect, it } from "vitest";
import { FailsafeTrialSchema, type Reply, ReplySchema } from "../../core/protocol.ts";
import { type Session, SessionContext } from "../session/session.ts";
import type { Order } from "./conditions.ts";
import { type Trial, useTrial } from "./use_trial.ts";

Object.assign(globalThis, { IS_REACT_ACT_ENVIRONMENT: true });

/** A server that answers when it is told to. */
class Slow {
  readonly asked: ((reply: Reply) => void)[] = [];
  readonly ask = () => new Promise<Reply>((resolve) => this.asked.push(resolve));
  async answers(reply: Reply): Promise<void> {
    await act(async () => this.asked.shift()?.(reply));
  }
}

const kAnswer = create(ReplySchema, {
  ok: true,
  result: { case: "failsafes", value: create(FailsafeTrialSchema, { seconds: 3 }) },
});

const clean: (() => void)[] = [];
afterEach(() => clean.splice(0).forEach((one) => void one()));

function shown(server: Slow) {
  const root = createRoot(document.createElement("div"));
  const session = { connection: server } as unknown as Session;
  let trial: Trial | undefined;
  function Panel({ order }: { order: Order | undefined }) {
    trial = useTrial(order);
    return null;
  }
  clean.push(() => act(() => root.unmount()));
  return {
    now: () => trial as Trial,
    asks: (order: Order | undefined) =>
      act(() =>
        root.render(
          <SessionContext value={session}>
            <Panel order={order} />
          </SessionContext>,
        ),
      ),
    tries: () => act(async () => void trial?.tryIt()),
  };
}

describe("conditions that are tried", () => {
  it("are tried one at a time, and answered beside themselves", async () => {
    const server = new Slow();
    const panel = shown(server);
    panel.asks({ robot: 1, speed: 1 });
    await panel.tries();
    await panel.tries();
    expect(server.asked).toHaveLength(1);
    expect(panel.now()).toMatchObject({ isUnderWay: true, answer: null });
    await server.answers(kAnswer);
    expect(panel.now()).toMatchObject({ isUnderWay: false, answer: { trial: { seconds: 3 } } });
  });
  it("have no answer any more once they are others, nor when they are the same again", async () => {
    const server = new Slow();
    const panel = shown(server);
    panel.asks({ robot: 1, speed: 1 });
    await panel.tries();
    await server.answers(kAnswer);
    panel.asks({ robot: 1, speed: 2 });
    expect(panel.now().answer).toBeNull();
    panel.asks({ robot: 1, speed: 1 });
    expect(panel.now().answer).toBeNull();
  });
  it("are not answered by what comes late, for others", async () => {
    const server = new Slow();
    const panel = shown(server);
    panel.asks({ robot: 1, speed: 1 });
    await panel.tries();
    panel.asks({ robot: 1, speed: 2 });
    expect(panel.now().isUnderWay).toBe(true);
    await server.answers(kAnswer);
    expect(panel.now()).toMatchObject({ isUnderWay: false, answer: null });
    panel.asks({ robot: 1, speed: 1 });
    expect(panel.now().answer).toBeNull();
  });
  it("are not sent while there is something wrong, and a refusal is told", async () => {
    const server = new Slow();
    const panel = shown(server);
    panel.asks(undefined);
    await panel.tries();
    expect(server.asked).toHaveLength(0);
    panel.asks({ robot: 9 });
    await panel.tries();
    await server.answers(create(ReplySchema, { ok: false, error: "there is no robot 9" }));
    expect(panel.now().answer).toEqual({ error: "there is no robot 9" });
  });
});
