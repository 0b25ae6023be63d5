import { lastPart } from "../../designer/session/pages.ts";
import type { RunContext } from "./run_context.ts";
import { situationOf } from "./situation.ts";

/** A live value becomes the text's. What runs is then what the text says, so it counts as tried. */
export async function writeBack(context: RunContext, port: string, value: string): Promise<void> {
  const { designer, store } = context;
  const { isOurs, isCurrent } = situationOf(context);
  const document = designer.state.document;
  const answer = await designer.ask({ case: "writeBack", value: { document, port, value } });
  if (!answer.ok) return;
  designer.say(`Wrote ${lastPart(port)} = ${value} to the text`);
  if (!isOurs || !isCurrent) return;
  const before = designer.document?.revision ?? 0n;
  const end = designer.store.subscribe((state) => {
    const revision = state.documents[document]?.revision ?? before;
    const { tried } = store.getState();
    if (revision === before || !tried) return;
    end();
    store.setState({ tried: { ...tried, revision } });
  });
  // The new text may have come before the answer.
  const { tried } = store.getState();
  if (tried && before !== tried.revision) {
    end();
    store.setState({ tried: { ...tried, revision: before } });
  }
}
