// Trying a configuration out: it is handed to the simulator, and made to run, wait and begin anew.
import { type Breakpoint, Control_Action } from "../../core/protocol.ts";
import { sentence } from "../../ui/words/sentence.ts";
import type { Follower } from "./follower.ts";
import { setupKey } from "./live_state.ts";
import type { MarkKeeper } from "./mark_keeper.ts";
import type { Operator } from "./operator.ts";
import { remember, remembered } from "./remembered.ts";
import { isMoving, runButton } from "./run_button.ts";
import { type RunContext, showPane, showProblem } from "./run_context.ts";
import { situationOf } from "./situation.ts";
import { subjectOf } from "./subject.ts";

export class Trials {
  constructor(
    private readonly context: RunContext,
    private readonly operator: Operator,
    private readonly marks: MarkKeeper,
    private readonly follower: Follower,
  ) {
    const { model, store } = context;
    model.subscribe("welcome", () => this.recall());
    store.subscribe(({ tried }, before) => {
      if (tried && tried !== before.tried) remember(window.sessionStorage, this.server, tried);
    });
  }

  /** The large button. */
  async press(): Promise<void> {
    switch (runButton(situationOf(this.context)).act) {
      case "try":
        await this.tryOut(true);
        break;
      case "execute":
        showPane(this.context.designer);
        await this.operator.control(Control_Action.EXECUTE);
        break;
      case "resume":
        await this.operator.control(Control_Action.RESUME);
        break;
      case "pause":
        await this.operator.control(Control_Action.PAUSE);
        break;
      case "release":
        await this.operator.control(Control_Action.RELEASE_STOP);
        break;
      case "now":
        await this.context.connection.ask({ case: "lookBack", value: { to: { case: "now", value: true } } });
        break;
      case "problems":
        showProblem(this.context.designer);
        break;
      case "none":
        this.context.designer.say(runButton(situationOf(this.context)).hint);
    }
  }

  /** The robots that run go on with what the text says now; where that can't be, they go on as they did. */
  async takeOver(): Promise<boolean> {
    return this.tryOut(false, true);
  }

  /** Hands the configuration to the simulator. */
  async tryOut(execute: boolean, takeOver = false): Promise<boolean> {
    const { designer, store } = this.context;
    const document = designer.document;
    if (!document) return false;
    const { robots, overlay, starts, subject } = store.getState();
    const found = subjectOf(document.declarations, subject, designer.state.page);
    if (!found || !(await this.operator.become())) return false;
    showPane(designer);
    store.setState({ isBusy: true, error: "", takenOver: "" });
    const before = await this.marks.renameBreakpoints(document.path);
    // Breakpoints go with their pages to where those run now, which is known when it stands ready.
    const waits = execute && (designer.state.marks[document.path] ?? []).some(({ breakpoint }) => breakpoint);
    const answer = await designer.link.ask({
      case: "try",
      value: {
        document: document.path,
        robot: found.name,
        count: robots,
        overlay,
        starts: [...starts],
        execute: execute && !waits,
        takeOver,
      },
    });
    store.setState({ isBusy: false });
    if (!answer.ok) {
      await this.goOnAsBefore(before, takeOver ? notTakenOver(answer.error) : answer.error);
      if (answer.problems.length > 0) showProblem(designer);
      return false;
    }
    const trial = answer.result.case === "trial" ? answer.result.value : undefined;
    const tried = {
      document: document.path,
      revision: document.revision,
      setup: setupKey(subject, { robots, overlay, starts }),
      mission: trial?.mission ?? "",
      notes: trial?.notes ?? [],
    };
    const takenOver = sentence(trial?.takenOver ?? "");
    store.setState({ tried, takenOver, field: null, fieldError: "" });
    if (waits) {
      await this.marks.renameBreakpoints(document.path);
      await this.operator.control(Control_Action.EXECUTE);
    }
    designer.say(takeOver ? takenOver : execute ? `${found.name} runs` : `${found.name} stands ready`);
    this.follower.look();
    return true;
  }

  /** What ran before goes on, under its names; `why`: what was tried does not. */
  private async goOnAsBefore(breakpoints: readonly Breakpoint[], why: string): Promise<void> {
    this.context.store.setState({ error: sentence(why) });
    for (const breakpoint of breakpoints)
      await this.context.connection.ask({ case: "setBreakpoint", value: { breakpoint } });
    this.context.designer.say(why);
  }

  /** One control cycle; where nothing has been tried yet, the first. */
  async step(): Promise<void> {
    const { isOurs, isCurrent, mode } = situationOf(this.context);
    if ((!isOurs || !isCurrent) && !isMoving(mode) && !(await this.tryOut(false))) return;
    await this.operator.control(Control_Action.SINGLE_CYCLE);
  }

  /** The robots leave; the next run begins anew. */
  async stop(): Promise<void> {
    await this.operator.control(Control_Action.RESTART);
  }

  private recall(): void {
    const state = this.context.store.getState();
    if (state.tried) return;
    const tried = remembered(window.sessionStorage, this.server, setupKey(state.subject, state));
    this.context.store.setState({ tried });
  }

  /** Which simulator it is: what was tried is remembered for it alone. */
  private get server(): string {
    return this.context.model.get("welcome")?.session ?? "";
  }
}

function notTakenOver(why: string): string {
  return `it can't be taken over: ${why}. "Run the change" begins anew`;
}
