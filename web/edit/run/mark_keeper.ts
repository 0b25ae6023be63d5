// Probes and breakpoints: set on a drawing, kept with its document by the designer's server, and obeyed by the simulator.

import { atSentence, type BreakpointInit, hitText } from "../../console/breakpoints/break_points.ts";
import type { Breakpoint } from "../../core/protocol.ts";
import type { Drawing, Mark } from "../../designer/session/protocol.ts";
import { drawnAtOf, endedMarks, type MarkInit, markAt, pinsOf, renamedBreakpoints, untoldMarks } from "./marks.ts";
import type { Operator } from "./operator.ts";
import { joined } from "./places.ts";
import { type RunContext, showPane } from "./run_context.ts";

export class MarkKeeper {
  private isTelling = false;

  constructor(
    private readonly context: RunContext,
    private readonly operator: Operator,
  ) {
    const { designer, model } = context;
    designer.store.subscribe(({ marks }, before) => {
      if (marks !== before.marks) this.takeMarks();
    });
    this.takeMarks();
    model.subscribe("clients", () => void this.tellKept());
    model.subscribe("halted", () => this.tellHalt());
  }

  /** `id`: what of the page that is shown it is set on; `trigger`: which condition of that transition. */
  async setBreakpoint(breakpointAt: (place: string) => BreakpointInit, id: string, trigger = ""): Promise<void> {
    const { drawing } = this.context.designer;
    const mark = drawing && markAt(drawing, id);
    const place = await this.placeToMark();
    if (!drawing || !mark || place === undefined) return;
    const { what } = breakpointAt(place);
    const reply = await this.operator.order({ case: "setBreakpoint", value: { breakpoint: { what } } });
    if (!reply.ok || reply.result.case !== "breakpoint") return;
    this.context.designer.say("Set a breakpoint");
    const port = what?.case === "condition" ? (what.value.port ?? "") : "";
    await this.setMark(drawing, { ...mark, place, trigger, port, breakpoint: { id: reply.result.value, what } });
  }

  /** Of no place of the drawing. @returns why it is not taken; empty: it is set */
  async setSentence(condition: string): Promise<string> {
    const value = { breakpoint: atSentence(condition) };
    const reply = await this.operator.ask({ case: "setBreakpoint", value });
    if (!reply.ok) return reply.error || "the simulator said no";
    this.context.designer.say("Set a breakpoint");
    return "";
  }

  async switchBreakpoint(breakpoint: Breakpoint, isOn: boolean): Promise<void> {
    await this.operator.order({ case: "setBreakpoint", value: { breakpoint: { ...breakpoint, isOff: !isOn } } });
  }

  async removeBreakMark({ id, breakpoint }: Mark): Promise<void> {
    if (breakpoint && breakpoint.id !== 0) await this.removeBreakpoint(breakpoint.id);
    else await this.removeMark(this.context.designer.state.document, id);
  }

  async removeBreakpoint(id: number): Promise<void> {
    await this.operator.order({ case: "removeBreakpoint", value: { id } });
    for (const [document, marks] of Object.entries(this.context.designer.state.marks)) {
      const ended = marks.filter(({ breakpoint }) => breakpoint && (id === 0 || breakpoint.id === id));
      for (const mark of ended) await this.removeMark(document, mark.id);
    }
  }

  /** Keeps the value of what is drawn in sight; `value`: below the page's place. */
  async pin(id: string, value: string): Promise<void> {
    const { drawing } = this.context.designer;
    const mark = drawing && markAt(drawing, id);
    const place = await this.placeToMark();
    if (!drawing || !mark || place === undefined) return;
    showPane(this.context.designer);
    await this.setMark(drawing, { ...mark, place, port: joined(place, value) });
  }

  async unpin(document: string, mark: number): Promise<void> {
    await this.removeMark(document, mark);
  }

  /** Calls breakpoints what they are called in the text that is about to run. @returns how they were */
  async renameBreakpoints(document: string): Promise<readonly Breakpoint[]> {
    const marks = this.context.designer.state.marks[document] ?? [];
    const known = this.context.model.get("breakpoints");
    for (const { id } of endedMarks(marks, known)) await this.removeMark(document, id);
    const renamed = renamedBreakpoints(marks, known);
    for (const breakpoint of renamed) {
      await this.context.connection.ask({ case: "setBreakpoint", value: { breakpoint } });
    }
    return known.filter(({ id }) => renamed.some((one) => one.id === id));
  }

  /** Tells the simulator of breakpoints that an earlier one had. */
  async tellKept(): Promise<void> {
    if (this.isTelling || !this.context.model.isOperator()) return;
    this.isTelling = true;
    for (const { document, mark } of untoldMarks(this.context.designer.state.marks)) {
      const breakpoint = { what: mark.breakpoint!.what };
      const reply = await this.context.connection.ask({ case: "setBreakpoint", value: { breakpoint } });
      if (!reply.ok || reply.result.case !== "breakpoint") continue;
      await this.removeMark(document, mark.id);
      const { page, node, from, to, trigger, place, port, drawn } = mark;
      const told = { page, node, from, to, trigger, place, port, drawn };
      const id = reply.result.value;
      await this.context.designer.link.ask({
        case: "setMark",
        value: { document, mark: { ...told, breakpoint: { ...breakpoint, id } } },
      });
    }
    this.isTelling = false;
  }

  private takeMarks(): void {
    const { marks } = this.context.designer.state;
    this.context.store.setState({ pins: pinsOf(marks), drawnAt: drawnAtOf(marks) });
    void this.tellKept();
  }

  /** Who has set a breakpoint wants to see what it stopped at. */
  private tellHalt(): void {
    const hit = this.context.model.get("halted")?.hits[0];
    if (!hit) return;
    this.context.designer.say(`Paused: ${hitText(hit)}`);
    if (this.context.store.getState().drawnAt.has(hit.breakpoint)) showPane(this.context.designer);
  }

  private async setMark(drawing: Drawing, mark: MarkInit): Promise<void> {
    const document = drawing.page?.document ?? "";
    await this.context.designer.ask({ case: "setMark", value: { document, mark } });
  }

  /** Where the page that is shown runs; where it would, while it does not. */
  private async placeToMark(): Promise<string | undefined> {
    const { place, places } = this.context.store.getState();
    if (places.includes(place)) return place;
    const { document, page } = this.context.designer.state;
    const answer = await this.context.designer.ask({ case: "findLive", value: { document, page, isPlanned: true } });
    return answer.ok && answer.result.case === "live" ? answer.result.value.places[0]?.path : undefined;
  }

  private async removeMark(document: string, id: number): Promise<void> {
    await this.context.designer.link.ask({ case: "removeMark", value: { document, id } });
  }
}
