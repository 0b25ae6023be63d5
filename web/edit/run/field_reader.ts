// The movement field over the map of the pane.
import { spokenPath } from "../../core/port_words.ts";
import { sentence } from "../../ui/words/sentence.ts";
import { gridFor, readArrows } from "./field_arrows.ts";
import type { Follower } from "./follower.ts";
import type { LiveState } from "./live_state.ts";
import type { RunContext } from "./run_context.ts";
import { situationOf } from "./situation.ts";

export class FieldReader {
  /** Only the newest is answered. */
  private request = 0;

  constructor(
    private readonly context: RunContext,
    private readonly follower: Follower,
  ) {}

  /** The movement field of a node of the page, or of its result, over what the map shows. */
  async read(node: string, visible: Parameters<typeof gridFor>[0], scale: number): Promise<void> {
    const { designer, store, model } = this.context;
    const scene = model.get("scene");
    const request = ++this.request;
    const tell = (field: LiveState["field"], fieldError: string) => {
      if (request === this.request && store.getState().showsField) store.setState({ field, fieldError });
    };
    if (!scene) {
      tell(null, "Nothing runs.");
      return;
    }
    const { area, columns, rows } = gridFor(visible, scene, scale);
    if (columns === 0 || rows === 0) {
      tell(null, "The map shows nothing of the mission's area.");
      return;
    }
    const { document, page } = designer.state;
    if (page === "") {
      tell(null, "The page of a file gives no movement; open one of its declarations.");
      return;
    }
    const robot = situationOf(this.context).isOurs ? this.follower.robot : 0; // others' robots don't run this
    const heading = model.placeOf(robot)?.heading ?? 0;
    const answer = await designer.link.ask({
      case: "readField",
      value: { document, page, node, robot, area, columns, rows, heading },
    });
    if (!answer.ok || answer.result.case !== "field") {
      tell(null, sentence(answer.error || "there is no field"));
      return;
    }
    const { arrows, note } = answer.result.value;
    const pitch = Math.min((area.xMax - area.xMin) / columns, (area.yMax - area.yMin) / rows);
    const title = spokenPath(node === "" ? page : node);
    tell({ arrows: readArrows(arrows), pitch, note, title }, "");
  }
}
