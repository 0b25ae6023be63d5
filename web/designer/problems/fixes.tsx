// The mends that the server offers for a problem: in the list of problems, and in the details of what it is about.
import { Button } from "../../ui/controls/controls.tsx";
import type { Problem } from "../session/protocol.ts";
import { useDesigner, useIsReadOnly } from "../session/use.ts";
import { applyFix, fixTitle } from "./apply_fix.ts";

export function Fixes({ problem }: { problem: Problem }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  if (isReadOnly) return null;
  return problem.fixes.map((fix) => (
    <Button key={fix.title} icon="check" className="problem-fix" onPress={() => void applyFix(designer, fix)}>
      {fixTitle(fix)}
    </Button>
  ));
}
