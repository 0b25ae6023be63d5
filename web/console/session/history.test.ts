import fc from "fast-check";
import { describe, expect, it } from "vitest";
import {
  emptyHistory,
  type LocalHistory,
  type MissionEdits,
  nameOf,
  nextRedo,
  nextUndo,
  recordEdit,
  redoLocal,
  undoLocal,
} from "./history.ts";

/** The server's side of the contract: numbers that grow, and a redo list that a new edit clears. */
class Mission {
  private done: bigint[] = [];
  private undone: bigint[] = [];
  private last = 0n;
  edit(): bigint {
    this.last += 1n;
    this.done.push(this.last);
    this.undone = [];
    return this.last;
  }
  undo(): void {
    this.undone.push(this.done.pop() as bigint);
  }
  redo(): void {
    this.done.push(this.undone.pop() as bigint);
  }
  edits(): MissionEdits {
    const undoNumber = this.done.at(-1) ?? 0n;
    const redoNumber = this.undone.at(-1) ?? 0n;
    return {
      undoNumber,
      redoNumber,
      undo: undoNumber ? `mission ${undoNumber}` : "",
      redo: redoNumber ? `mission ${redoNumber}` : "",
    };
  }
}

describe("undo over layout and mission", () => {
  it("undoes whatever happened last, and redoes it in turn", () => {
    fc.assert(
      fc.property(fc.array(fc.boolean(), { maxLength: 20 }), (kinds) => {
        const mission = new Mission();
        let local: LocalHistory<number> = emptyHistory();
        const names: string[] = [];
        kinds.forEach((isLocal, i) => {
          if (isLocal) {
            local = recordEdit(local, {
              name: `layout ${i}`,
              before: i,
              after: i + 1,
              since: mission.edits().undoNumber,
            });
            names.push(`layout ${i}`);
          } else {
            names.push(`mission ${mission.edit()}`);
          }
        });
        const undone: string[] = [];
        for (let next = nextUndo(local, mission.edits()); next; next = nextUndo(local, mission.edits())) {
          undone.push(nameOf(next));
          if (next.kind === "local") local = undoLocal(local);
          else mission.undo();
        }
        expect(undone).toEqual([...names].reverse());
        const redone: string[] = [];
        for (let next = nextRedo(local, mission.edits()); next; next = nextRedo(local, mission.edits())) {
          redone.push(nameOf(next));
          if (next.kind === "local") local = redoLocal(local);
          else mission.redo();
        }
        expect(redone).toEqual(names);
      }),
    );
  });
  it("has nothing to undo at first", () => {
    expect(nextUndo(emptyHistory(), new Mission().edits())).toBeUndefined();
    expect(nameOf(nextRedo(emptyHistory(), new Mission().edits()))).toBe("");
  });
  it("forgets undone layout edits when a new one is made", () => {
    const edit = { name: "a", before: 0, after: 1, since: 0n };
    const history = recordEdit(undoLocal(recordEdit(emptyHistory<number>(), edit)), { ...edit, name: "b" });
    expect(nextRedo(history, new Mission().edits())).toBeUndefined();
  });
});
