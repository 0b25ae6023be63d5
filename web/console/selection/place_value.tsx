import type { Point } from "../../core/geometry.ts";
import { placeText } from "../../core/place_notation.ts";
import { IconButton } from "../../ui/controls/controls.tsx";
import { copyPlace } from "../session/copy_place.ts";
import { usePart, useSession } from "../session/session.ts";

const kScale = 10; // pixels per metre: places of the map to a decimetre

/** Where something is, in the notation that was chosen. */
export function PlaceValue({ at }: { at: Point }) {
  const session = useSession();
  const { notation } = usePart("map");
  const text = placeText(usePart("scene"), at, notation, kScale);
  return (
    <>
      {text} <IconButton icon="copy" label="Copy the place" onPress={() => void copyPlace(session, text)} />
    </>
  );
}
