// Who steers the simulator: this page asks for the operator's place before it orders anything, and hands it on.
import { create } from "@bufbuild/protobuf";
import { elsewhen } from "../../console/session/elsewhen.ts";
import { type Control_Action, type Order, type Reply, ReplySchema } from "../../core/protocol.ts";
import { withToken } from "../../core/server_link.ts";
import { sentence } from "../../ui/words/sentence.ts";
import type { RunContext } from "./run_context.ts";

const kTakeOver = 1500; // ms in which another window hands over
const kHandOver = 30_000; // ms in which the console that was opened becomes the operator

export class Operator {
  private handsOverUntil = 0;
  private known = new Set<number>();

  constructor(private readonly context: RunContext) {}

  async control(action: Control_Action): Promise<Reply> {
    return this.order({ case: "control", value: { action } });
  }

  /** Asks of the simulator, as its operator, and tells the person where the answer is no. */
  async order(body: Order): Promise<Reply> {
    const why = elsewhen(this.context.model);
    if (why !== undefined) this.context.designer.tell(why, "hold");
    const reply = await this.ask(body);
    if (!reply.ok && why === undefined)
      this.context.designer.tell(sentence(reply.error || reply.diagnostics[0]?.message || "the simulator said no"));
    return reply;
  }

  /** The same for who tells the answer himself. */
  async ask(body: Order): Promise<Reply> {
    const why = elsewhen(this.context.model);
    if (why !== undefined) return create(ReplySchema, { ok: false, error: why });
    await this.become();
    return this.context.connection.ask(body);
  }

  /** @returns whether it is, or has been asked for it of who is */
  async become(): Promise<boolean> {
    const { designer, model, connection } = this.context;
    if (model.isOperator()) return true;
    const reply = await connection.ask({ case: "takeOperator", value: {} });
    if (!reply.ok) designer.tell(sentence(reply.error));
    // Another window hands it over at once; a console asks who sits there.
    if (reply.ok && !(await this.isSoon()))
      designer.tell("A console is the operator and has been asked to hand over.", "hold");
    return reply.ok;
  }

  /** The same run in the operator console, which becomes the operator. */
  openConsole(): void {
    const { designer, model } = this.context;
    this.known = new Set(model.get("clients")?.clients.map(({ id }) => id));
    this.handsOverUntil = Date.now() + kHandOver;
    window.open(withToken(designer.page, "./"), "_blank", "noopener");
  }

  /** Others have come, or ask for the place. */
  clientsChanged(): void {
    this.handOver();
    this.giveWay();
  }

  /** To the console that was opened. */
  private handOver(): void {
    const { model, connection } = this.context;
    if (Date.now() > this.handsOverUntil || !model.isOperator()) return;
    const fresh = model.get("clients")?.clients.find((client) => client.isConnected && !this.known.has(client.id));
    if (!fresh) return;
    this.handsOverUntil = 0;
    void connection.ask({ case: "passOperator", value: { client: fresh.id } });
  }

  /** Another window, or a console, asks for the operator's place: nobody here has to be asked. */
  private giveWay(): void {
    const { model, connection } = this.context;
    const asks = model.get("clients")?.asks ?? 0;
    if (asks !== 0 && model.isOperator()) void connection.ask({ case: "passOperator", value: { client: asks } });
  }

  private isSoon(): Promise<boolean> {
    const { model } = this.context;
    if (model.isOperator()) return Promise.resolve(true);
    return new Promise((resolve) => {
      const done = () => {
        clearTimeout(timer);
        stop();
        resolve(model.isOperator());
      };
      const timer = setTimeout(done, kTakeOver);
      const stop = model.subscribe("clients", () => model.isOperator() && done());
    });
  }
}
