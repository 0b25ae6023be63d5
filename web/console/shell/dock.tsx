// The docks around the map: a rail of buttons, the panel that is shown, a border that can be dragged.
import { type KeyboardEvent, type PointerEvent, Suspense, useRef, useState } from "react";
import { Button as AriaButton } from "react-aria-components";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button, Hint, IconButton } from "../../ui/controls/controls.tsx";
import { ErrorFence } from "../../ui/controls/error_fence.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { MenuButton } from "../../ui/controls/menus.tsx";
import { panels } from "../extensions/extensions.ts";
import { activePanel, movePanel, panelsIn, resizeDock, toggleDock, togglePanel } from "../session/layout.ts";
import type { Dock as DockName, Panel } from "../session/registry.ts";
import { useLayout, useSession } from "../session/session.ts";

export function Rail({ side }: { side: "left" | "right" }) {
  const layout = useLayout();
  const here = panelsIn(layout, panels, side);
  if (here.length === 0) return null;
  return (
    <nav className={`rail ${side}`} aria-label={side === "left" ? "Panels on the left" : "Panels on the right"}>
      {here.map((panel) => (
        <PanelButton key={panel.id} panel={panel} className="rail-button" />
      ))}
    </nav>
  );
}

export function PanelButton({ panel, className }: { panel: Panel; className: string }) {
  const { ui } = useSession();
  const layout = useLayout();
  const dock = layout.moved[panel.id] ?? panel.dock;
  const isShown = layout.docks[dock].open && activePanel(layout, panels, dock)?.id === panel.id;
  return (
    <Hint
      text={`${isShown ? "Hide" : "Show"} ${panel.title}`}
      {...(panel.shortcut ? { shortcut: shownShortcut(panel.shortcut) } : {})}
    >
      <AriaButton
        className={className}
        aria-pressed={isShown}
        onPress={() => ui.set("layout", togglePanel(ui.get("layout"), ui.shownLayout, panels, panel))}
      >
        <Icon name={panel.icon} />
        <span>{panel.short ?? panel.title}</span>
        {panel.useBadge && <Badge use={panel.useBadge} />}
      </AriaButton>
    </Hint>
  );
}

function Badge({ use }: { use: () => number }) {
  const count = use();
  return count > 0 ? <span className="badge">{count > 99 ? "99+" : count}</span> : null;
}

export function Dock({ side }: { side: DockName }) {
  const { ui } = useSession();
  const layout = useLayout();
  const panel = activePanel(layout, panels, side);
  if (!layout.docks[side].open || !panel) return null;
  const size = layout.docks[side].size;
  const Shown = panel.component;
  return (
    <section
      className={`dock ${side}`}
      style={side === "bottom" ? { height: size } : { width: size }}
      aria-label={panel.title}
    >
      <Splitter side={side} />
      <header>
        <h2>{panel.title}</h2>
        <MenuButton
          label={`${panel.title}: place`}
          trigger={
            <Button tone="quiet" className="square" aria-label={`Move ${panel.title}`}>
              <Icon name="more" />
            </Button>
          }
          groups={[
            {
              title: "Move to",
              entries: (["left", "right", "bottom"] as const).map((dock) => ({
                id: dock,
                label: { left: "Left side", right: "Right side", bottom: "Drawer" }[dock],
                isDisabled: dock === side,
                run: () => ui.set("layout", movePanel(ui.get("layout"), panel, dock)),
              })),
            },
          ]}
        />
        <IconButton
          icon="close"
          label={`Close ${panel.title}`}
          onPress={() => ui.set("layout", toggleDock(ui.get("layout"), ui.shownLayout, side))}
        />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a region that scrolls has to be reached by keyboard */}
      <section className="panel" tabIndex={0} aria-label={`${panel.title} content`}>
        <ErrorFence key={panel.id} name={panel.title}>
          <Suspense fallback={<p className="empty">Loading…</p>}>
            <Shown />
          </Suspense>
        </ErrorFence>
      </section>
    </section>
  );
}

/** Dragged by pointer, or moved with arrow keys while it has the focus. */
function Splitter({ side }: { side: DockName }) {
  const { ui } = useSession();
  const size = useLayout().docks[side].size;
  const drag = useRef<{ at: number; size: number } | null>(null);
  const [dragged, setDragged] = useState(false);
  const along = (event: PointerEvent) => (side === "bottom" ? event.clientY : event.clientX);
  const resize = (next: number) => ui.set("layout", resizeDock(ui.get("layout"), side, next));
  const keys = (event: KeyboardEvent) => {
    const larger = { left: "ArrowRight", right: "ArrowLeft", bottom: "ArrowUp" }[side];
    const smaller = { left: "ArrowLeft", right: "ArrowRight", bottom: "ArrowDown" }[side];
    if (event.key !== larger && event.key !== smaller) return;
    event.preventDefault();
    resize(size + (event.key === larger ? 16 : -16));
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: a separator that can be moved is no <hr>
    <div
      className={`splitter ${side} ${dragged ? "dragged" : ""}`}
      role="separator"
      tabIndex={0}
      aria-label={`Width of the ${side} panel`.replace("Width of the bottom", "Height of the bottom")}
      aria-orientation={side === "bottom" ? "horizontal" : "vertical"}
      aria-valuenow={size}
      aria-valuemin={140}
      aria-valuemax={640}
      onKeyDown={keys}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        drag.current = { at: along(event), size };
        setDragged(true);
      }}
      onPointerMove={(event) => {
        if (!drag.current) return;
        const moved = along(event) - drag.current.at;
        resize(drag.current.size + (side === "left" ? moved : -moved));
      }}
      onLostPointerCapture={() => {
        drag.current = null;
        setDragged(false);
      }}
    />
  );
}
