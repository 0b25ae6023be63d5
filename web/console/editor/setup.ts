// The editor of missions and overlays.
import type { Extension } from "@codemirror/state";
import { Complete_Language } from "../../core/protocol.ts";
import { textEditorParts } from "../../ui/text/parts.ts";
import type { Session } from "../session/session.ts";
import { mdl, odl } from "./languages.ts";

export function editorParts({ connection }: Session, language: Complete_Language): Extension[] {
  return textEditorParts({
    language: language === Complete_Language.OVERLAY ? odl() : mdl(),
    letter: /[\w-]/,
    complete: async (text, cursor) => {
      const { result } = await connection.ask({ case: "complete", value: { language, text, cursor } });
      return result.case === "completions" ? result.value : undefined;
    },
  });
}
