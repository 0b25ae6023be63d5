// What a dialog shows of the document: as that stands now, not as it stood when the dialog was opened.
import { useEffect, useState } from "react";
import { useDesigner } from "./use.ts";

/** A field's text: the document's until somebody types in it. */
export function useFollowing(current: string): [string, (typed: string) => void] {
  const [typed, setTyped] = useState<string | null>(null);
  return [typed ?? current, setTyped];
}

/** Closes the dialog, and says why, when what it is about is not in the document any more. */
export function useClosedWithout(isThere: boolean, name: string): void {
  const designer = useDesigner();
  useEffect(() => {
    if (isThere) return;
    designer.store.setState({ dialog: "" });
    designer.tell(`${name} is not there any more.`, "hold");
  }, [isThere, name, designer]);
}
