// The component library at the left: by groups, searched, dragged onto the canvas or placed by Enter.
import { useMemo, useState } from "react";
import { Search } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { toneOf } from "../drawing/form.ts";
import { declarationOf } from "../session/pages.ts";
import { type Component, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, useDrawing, useIsReadOnly, usePart } from "../session/use.ts";
import { canvasStore } from "../sight/canvas_store.ts";
import { NodeIcon } from "../views/icons.tsx";
import { firstSentence, groupsOf, isActuator, isInPalette, isOpenAtFirst, matchingComponents } from "./groups.ts";
import { palettePage } from "./palette_pages.tsx";
import { place } from "./place.ts";
import { dragByTouch, kDragged } from "./touch_drag.ts";
import { keepUnfolded, readUnfolded } from "./unfolded.ts";

const kNone: readonly Component[] = [];

export function PalettePanel() {
  const components = usePart((state) => state.palettes[state.document]?.components ?? kNone);
  const drawing = useDrawing();
  const [query, setQuery] = useState("");
  const [unfolded, setUnfolded] = useState(() => readUnfolded(window.localStorage));
  // Nothing is a part of itself.
  const owner = usePart((state) => declarationOf(state.page));
  const isStates = drawing?.kind === Drawing_Kind.STATES;
  const isRobot = drawing?.kind === Drawing_Kind.ROBOT;
  const groups = useMemo(() => {
    const usable = components.filter(
      (one) => one.name !== owner && isInPalette(one, isStates) && (isRobot || !isActuator(one)),
    );
    return groupsOf(query ? matchingComponents(query, usable) : usable);
  }, [components, query, isStates, isRobot, owner]);
  const own = palettePage(drawing);
  if (own) return own;
  const fold = (name: string, isOpen: boolean) => {
    const next = { ...unfolded, [name]: !isOpen };
    setUnfolded(next);
    keepUnfolded(window.localStorage, next);
  };
  return (
    <div className="palette">
      <div className="palette-search">
        <Search label="Find a component" value={query} onChange={setQuery} />
      </div>
      {groups.map((group) => {
        const isOpen = query !== "" || (unfolded[group.name] ?? isOpenAtFirst(group.name, isStates));
        return (
          <section key={group.name} aria-label={group.name}>
            <h3>
              <button
                type="button"
                className="palette-group"
                aria-expanded={isOpen}
                onClick={() => fold(group.name, isOpen)}
              >
                <Icon name={isOpen ? "down" : "right"} />
                {group.name}
                <span className="muted">{group.components.length}</span>
              </button>
            </h3>
            {isOpen && (
              <ul>
                {group.components.map((component) => (
                  <Entry key={component.name} component={component} />
                ))}
              </ul>
            )}
          </section>
        );
      })}
      {groups.length === 0 && <p className="empty small">Nothing is called that.</p>}
    </div>
  );
}

function Entry({ component }: { component: Component }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const title = component.title || component.name;
  return (
    <li>
      <button
        type="button"
        className={`palette-entry tone-${toneOf(component.shape)}`}
        data-component={component.name}
        draggable={!isReadOnly}
        disabled={isReadOnly}
        title={[title, component.help].filter((one) => one !== "").join("\n\n")}
        onDragStart={(event) => {
          canvasStore.setState({ dragged: component.name });
          event.dataTransfer.setData(kDragged, component.name);
          event.dataTransfer.setData("text/plain", component.name);
          event.dataTransfer.effectAllowed = "copy";
        }}
        onDragEnd={() => canvasStore.setState({ dragged: "", aimedAt: "" })}
        onPointerDown={(event) => {
          if (!isReadOnly) dragByTouch(designer, component.name, title, event);
        }}
        onClick={(event) => {
          if (event.detail < 2) void place(designer, component.name, null); // a double click places one, too
        }}
      >
        <span className="node-icon">
          <NodeIcon icon={component.icon} component={component.name} shape={component.shape} />
        </span>
        <span className="palette-names">
          <span className="palette-title">{title}</span>
          <span className="small muted palette-help">{firstSentence(component.help)}</span>
        </span>
      </button>
    </li>
  );
}
