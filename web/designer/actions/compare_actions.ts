// Comparing with another version, and going from difference to difference.
import { comparedWith, entriesOf } from "../compare/compared.ts";
import type { Action } from "../session/action.ts";
import type { Designer } from "../session/designer.ts";
import { stopComparing } from "../session/documents.ts";
import type { Differences_Entry } from "../session/protocol.ts";
import { camera, nodeElement } from "../sight/view.ts";
import { kClosed } from "./blocks.ts";

export function compareActions(designer: Designer): Action[] {
  const { store, state, document } = designer;
  const isComparing = comparedWith(state) !== undefined;
  const not = isComparing ? undefined : "Compare with another version first";
  return [
    {
      id: "compare",
      label: "Compare with…",
      group: "Compare",
      icon: "layers",
      shortcut: "shift+d",
      blocked: document ? undefined : kClosed,
      run: () => store.setState({ dialog: "compare" }),
    },
    {
      id: "next-difference",
      label: "Next difference",
      group: "Compare",
      shortcut: "f7",
      everywhere: true,
      blocked: not,
      run: () => stepTo(designer, 1),
    },
    {
      id: "previous-difference",
      label: "Previous difference",
      group: "Compare",
      shortcut: "shift+f7",
      everywhere: true,
      blocked: not,
      run: () => stepTo(designer, -1),
    },
    {
      id: "stop-comparing",
      label: "Stop comparing",
      group: "Compare",
      blocked: not,
      run: () => stopComparing(designer),
    },
  ];
}

function stepTo(designer: Designer, step: 1 | -1): void {
  const entries = entriesOf(designer.state);
  if (entries.length === 0) {
    designer.say("There is no difference");
    return;
  }
  const before = designer.state.difference;
  const at = before < 0 ? (step > 0 ? 0 : entries.length - 1) : (before + step + entries.length) % entries.length;
  goToDifference(designer, entries[at]!, at);
}

/** Goes where it is drawn, and says what it is. */
export function goToDifference(designer: Designer, entry: Differences_Entry, at: number): void {
  const { document, page, node } = placeOf(designer, entry);
  designer.store.setState({ difference: at });
  designer.say(`Difference ${at + 1}: ${entry.text}`);
  designer.navigation.goTo(document, page, node.startsWith("-") ? "" : node);
  if (node !== "") bringIntoSight(node);
}

/** Where a difference is drawn: classes, operators and binding points have no page of their own. */
function placeOf({ state, document }: Designer, { page, node }: Differences_Entry) {
  const owner = page.split(".")[0]!;
  const kind = document?.declarations.find((one) => one.name === owner)?.kind ?? "";
  const isDrawn = page === "" || ["assemblage", "robot", "society"].includes(kind);
  return { document: state.document, page: isDrawn ? page : "", node: isDrawn ? node : owner };
}

const kPatience = 2000; // [ms]
const kWay = 200; // of the camera [ms]
let newest = 0;

/** Once it is drawn; what is in sight already stays where it is. Only what was asked for last. */
function bringIntoSight(id: string): void {
  const mine = ++newest;
  const begin = performance.now();
  let last = "";
  const look = () => {
    if (mine !== newest) return;
    const canvas = document.querySelector(".canvas");
    const element = nodeElement(id) ?? transitionElement(id);
    const isReady = element !== null && canvas?.getAttribute("aria-busy") === "false";
    // While the camera moves nothing can be told of where it will be.
    const now = isReady ? JSON.stringify(element.getBoundingClientRect()) : "";
    if (isReady && now === last) moveTo(element, canvas);
    else if (performance.now() - begin < kPatience) requestAnimationFrame(look);
    last = now;
  };
  look();
}

function transitionElement(id: string): Element | null {
  return document.querySelector(`[data-transition="${CSS.escape(id)}"]`);
}

/** Without coming nearer: what is around it stays in sight. */
function moveTo(element: Element, canvas: Element): void {
  const [inner, outer] = [element.getBoundingClientRect(), canvas.getBoundingClientRect()];
  const isIn =
    inner.left >= outer.left && inner.right <= outer.right && inner.top >= outer.top && inner.bottom <= outer.bottom;
  const flow = camera();
  if (isIn || !flow) return;
  const at = flow.screenToFlowPosition({ x: inner.left + inner.width / 2, y: inner.top + inner.height / 2 });
  void flow.setCenter(at.x, at.y, { zoom: flow.getZoom(), duration: kWay });
}
