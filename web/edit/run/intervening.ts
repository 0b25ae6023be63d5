// What a person does to a robot that runs: held values, and states that it is sent to.
import { spokenPath } from "../../core/port_words.ts";
import type { Follower } from "./follower.ts";
import type { Operator } from "./operator.ts";
import type { RunContext } from "./run_context.ts";

export class Intervening {
  constructor(
    private readonly context: RunContext,
    private readonly operator: Operator,
    private readonly follower: Follower,
  ) {}

  /** In the next cycle the selected robot's sequence goes to the state; `sequence`: its path. */
  async force(sequence: string, state: string): Promise<void> {
    const { robot } = this.follower;
    const { ok } = await this.operator.order({ case: "forceState", value: { robot, sequence, state } });
    if (ok) this.context.designer.say(`${this.context.model.get("roster").nameOf(robot)} goes to ${state}`);
  }

  /** From the next cycle on the selected robot's output is held at the value. */
  async hold(port: string, value: string): Promise<boolean> {
    const { robot } = this.follower;
    const { ok } = await this.operator.order({ case: "holdValue", value: { robot, port, value } });
    if (ok) this.context.designer.say(`Held ${spokenPath(port)} at ${value}`);
    return ok;
  }

  /** Robot 0: of all; port empty: all values. */
  async release(robot: number, port: string): Promise<void> {
    const { ok } = await this.operator.order({ case: "releaseValue", value: { robot, port } });
    if (ok) this.context.designer.say(port === "" ? "Released all values" : `Released ${spokenPath(port)}`);
  }
}
