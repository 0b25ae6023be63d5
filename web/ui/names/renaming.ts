// Another name for something in all files of a project: what the server answers to it, and how that is told.
import type { Plan } from "../../core/names.ts";
import { count } from "../words/format.ts";

/** A stretch of a text [bytes]. */
export interface TextPlace {
  document: string;
  begin: number;
  end: number;
}

/** What a new name would bring. */
export type RenamingPlan =
  | { is: "plan"; plan: Plan }
  | { is: "local" } // it has no name of its own yet: only the page knows it
  | { is: "refused"; why: string; place?: TextPlace };

export function placesIn({ files }: Pick<Plan, "files">): number {
  return files.reduce((sum, file) => sum + file.uses.length, 0);
}

/** More than what is shown changes, or something can't: that is looked at first. */
export function isWide({ files }: Plan): boolean {
  return files.length > 1 || files.some((file) => file.kept !== "");
}

export function summary(plan: Plan): string {
  const changed = plan.files.filter((file) => file.kept === "");
  return `${count(placesIn(plan), "place")} in ${count(changed.length, "file")}`;
}

/** What was done. */
export function renamedText(plan: Plan): string {
  const notes = plan.notes.length > 0 ? `. ${plan.notes.join(". ")}` : "";
  return `Renamed ${plan.from} to ${plan.to}: ${summary(plan)}${notes}`;
}
