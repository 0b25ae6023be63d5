// Looking at another moment than now: nothing is ordered there.
import type { Model } from "../../core/model.ts";

/** Why nothing can be ordered; nothing: it can, as far as the moment goes. */
export function elsewhen(model: Model): string | undefined {
  if (model.isRecording()) return "This is a recording: nothing goes on in it.";
  return model.isElsewhen() ? "You are looking at another moment: go back to now first." : undefined;
}
