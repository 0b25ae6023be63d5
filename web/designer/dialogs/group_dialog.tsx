// An assemblage is made of the selection: it is asked for a name, and for what it lacks to have one output.

import { Button } from "../../ui/controls/controls.tsx";
import { selectionByKind } from "../actions/editing.ts";
import { onPitch } from "../arrange/elk.ts";
import type { Designer } from "../session/designer.ts";
import { onceDrawn } from "../session/once_drawn.ts";
import { lastPart } from "../session/pages.ts";
import { type ChangeInit, type Drawing, Node_Shape } from "../session/protocol.ts";
import { useDesigner, useDrawing, usePart } from "../session/use.ts";
import { isArranged, placesOf, sizesOf } from "../sight/use_places.ts";
import { Ask, editOf } from "./dialogs.tsx";
import { outputsOf, withOneOutput } from "./one_output.ts";

export function GroupDialog() {
  const designer = useDesigner();
  const drawing = useDrawing();
  const page = usePart((state) => state.page);
  usePart((state) => state.selection);
  const { nodes } = selectionByKind(designer);
  return (
    <Ask
      title={`Make an assemblage of ${nodes.length === 1 ? nodes[0] : `${nodes.length} nodes`}`}
      label="Name"
      first=""
      button="Make it"
      help="What drives them from outside becomes its parameters."
      done={async (name) => {
        const before = drawing && placesBefore(drawing);
        const at = drawing && middleOf(drawing, nodes);
        const changes: ChangeInit[] = [
          ...(before ? [before] : []),
          { case: "group", value: { page, nodes, name, ...(at ?? {}) } },
        ];
        const answer = await designer.link.ask(editOf(designer, `make assemblage ${name}`, ...changes));
        if (answer.ok) void selectMade(designer, name);
        return answer.error;
      }}
    >
      {drawing && <SeveralOutputs drawing={drawing} nodes={nodes} />}
    </Ask>
  );
}

/** Where more than one value would come out: which, and a way out of it. */
function SeveralOutputs({ drawing, nodes }: { drawing: Drawing; nodes: readonly string[] }) {
  const designer = useDesigner();
  const able = new Set(drawing.nodes.filter(({ shape }) => !kNoParts.has(shape)).map(({ name }) => name));
  const chosen = nodes.filter((name) => able.has(name));
  const outputs = outputsOf(new Set(chosen), drawing.wires);
  if (outputs.length < 2) return null;
  const all = withOneOutput(chosen, drawing.wires, able);
  const added = all?.filter((name) => !chosen.includes(name)) ?? [];
  return (
    <p className="notice hold" role="status">
      <span className="grow">
        An assemblage gives one value, and these give several: {named(outputs)}.
        {all ? ` They come together in what they lead to.` : " Connect them to one operator first."}
      </span>
      {all && (
        <Button onPress={() => designer.select([...nodes, ...added])}>
          Take {added.length > 3 ? `${added.length} more` : named(added)} as well
        </Button>
      )}
    </p>
  );
}

/** What the server does not put into an assemblage. */
const kNoParts: ReadonlySet<Node_Shape> = new Set([Node_Shape.PARAMETER, Node_Shape.ACTUATOR]);

function named(nodes: readonly string[]): string {
  return nodes.map(lastPart).join(", ");
}

/** The text says where everything stands from now on: what becomes the inside keeps its arrangement. */
function placesBefore(drawing: Drawing): ChangeInit | undefined {
  const places = placesOf(drawing);
  if (!places || isArranged(drawing)) return undefined;
  const nodes = [...places].map(([node, { x, y }]) => ({ node, x, y }));
  return { case: "arrange", value: { page: drawing.page?.path ?? "", nodes } };
}

/** Of a usual node [px]. */
const kHalf = { x: 90, y: 40 };

/** Where a node stands that takes the place of these. */
function middleOf(drawing: Drawing, nodes: readonly string[]): { x: number; y: number } | undefined {
  const places = placesOf(drawing);
  const sizes = sizesOf(drawing);
  const boxes = nodes.flatMap((name) => {
    const at = places?.get(name);
    const size = sizes.get(name);
    return at && size ? [{ ...at, right: at.x + size.width, bottom: at.y + size.height }] : [];
  });
  if (boxes.length === 0) return undefined;
  const x = (Math.min(...boxes.map((box) => box.x)) + Math.max(...boxes.map((box) => box.right))) / 2;
  const y = (Math.min(...boxes.map((box) => box.y)) + Math.max(...boxes.map((box) => box.bottom))) / 2;
  return { x: onPitch(x - kHalf.x), y: onPitch(y - kHalf.y) };
}

/** As soon as it is drawn, which may be a moment after the answer. */
async function selectMade(designer: Designer, component: string): Promise<void> {
  const made = await onceDrawn(
    designer,
    () => designer.drawing?.nodes.find((node) => node.component === component)?.name,
  );
  if (made) designer.select([made]);
}
