// Running, for one page of the designer: its connection to the simulator, and the parts that do something with it.

import type { Session } from "../../console/session/session.ts";
import { Ui } from "../../console/session/ui.ts";
import { Connection, tabKey } from "../../core/connection.ts";
import { Model } from "../../core/model.ts";
import { selectRobots } from "../../core/selection.ts";
import type { Designer } from "../../designer/session/designer.ts";
import { FieldReader } from "./field_reader.ts";
import { Follower } from "./follower.ts";
import { Intervening } from "./intervening.ts";
import { createLiveState, type DrawnAt } from "./live_state.ts";
import { MarkKeeper } from "./mark_keeper.ts";
import { Operator } from "./operator.ts";
import type { RunContext } from "./run_context.ts";
import { Trials } from "./trials.ts";

/** What a console keeps over reloads is the console's, not ours. */
const kForgetful = { getItem: () => null, setItem: () => {} } as unknown as Storage;

export class Live implements RunContext {
  readonly model = new Model();
  readonly connection: Connection;
  readonly session: Session;
  readonly store = createLiveState();
  readonly operator: Operator;
  readonly marks: MarkKeeper;
  readonly follower: Follower;
  readonly trials: Trials;
  readonly intervening: Intervening;
  readonly field: FieldReader;

  constructor(readonly designer: Designer) {
    this.connection = new Connection(this.model, {
      page: designer.page,
      name: "Designer",
      clientKey: tabKey(window.sessionStorage),
    });
    this.session = { model: this.model, connection: this.connection, ui: this.consoleUi() };
    this.model.updateMap({ robotLabels: "all" });
    this.operator = new Operator(this);
    this.follower = new Follower(this);
    this.marks = new MarkKeeper(this, this.operator);
    this.trials = new Trials(this, this.operator, this.marks, this.follower);
    this.intervening = new Intervening(this, this.operator, this.follower);
    this.field = new FieldReader(this, this.follower);
    this.model.subscribe("roster", () => this.selectSomebody());
    // After the marks: what is told as the operator has to be told before the place is given away.
    this.model.subscribe("clients", () => this.operator.clientsChanged());
    this.connection.connect();
  }

  /** To where it is drawn. */
  goTo({ document, page, id }: DrawnAt): void {
    this.designer.navigation.goTo(document, page, id);
    this.designer.select([id]);
  }

  /** What parts of the console that stand in the pane go by. */
  private consoleUi(): Ui {
    const ui = new Ui(this.model, kForgetful, { width: window.innerWidth, height: window.innerHeight });
    ui.subscribe("notice", () => {
      const notice = ui.get("notice");
      if (notice) this.designer.tell(notice.text, notice.tone);
    });
    return ui;
  }

  private selectSomebody(): void {
    const first = this.model.get("roster").robots[0];
    if (first && this.model.get("selection").robots.length === 0) this.model.select(selectRobots([first.id]));
  }
}

const kLives = new WeakMap<Designer, Live>();

/** The page's; it connects when it is first asked for. */
export function liveOf(designer: Designer): Live {
  let live = kLives.get(designer);
  if (!live) {
    live = new Live(designer);
    kLives.set(designer, live);
  }
  return live;
}

/** Without connecting. */
export function knownLive(designer: Designer): Live | undefined {
  return kLives.get(designer);
}
