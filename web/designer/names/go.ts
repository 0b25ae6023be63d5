// Going to a place of a text: its page and what is drawn of it, and the text itself where that is open.
import type { TextPlace } from "../../ui/names/renaming.ts";
import type { Designer } from "../session/designer.ts";
import { AskLanguage_What } from "../session/protocol.ts";

export async function goToText(designer: Designer, { document, begin, end }: TextPlace): Promise<void> {
  if (!designer.state.documents[document] && !(await designer.navigation.open(document))) return;
  const answer = await designer.ask({
    case: "askLanguage",
    value: { document, what: AskLanguage_What.PAGE, cursor: begin },
  });
  if (answer.result.case === "location")
    designer.navigation.goTo(document, answer.result.value.page, answer.result.value.node);
  designer.store.setState({ reveal: { begin, end, focus: false } });
}
