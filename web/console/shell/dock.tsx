// The docks around the map: a rail of buttons, the panel that is shown, a border that can be dragged.
import { type ReactNode, Suspense, useDeferredValue } from "react";
import { Button as AriaButton } from "react-aria-components";
import { shownShortcut } from "../../ui/commands/keys.ts";
import { Button, Hint, IconButton } from "../../ui/controls/controls.tsx";
import { ErrorFence } from "../../ui/controls/error_fence.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { MenuButton } from "../../ui/controls/menus.tsx";
import { Splitter } from "../../ui/controls/splitter.tsx";
import { panels } from "../extensions/extensions.ts";
import {
  activePanel,
  kDockSizes,
  movePanel,
  panelsIn,
  resizeDock,
  toggleDock,
  togglePanel,
} from "../session/layout.ts";
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
  const button = <ShownPanelButton panel={panel} className={className} />;
  return panel.useIsThere ? <WhereThere use={panel.useIsThere}>{button}</WhereThere> : button;
}

function WhereThere({ use, children }: { use: () => boolean; children: ReactNode }) {
  return use() ? children : null;
}

function ShownPanelButton({ panel, className }: { panel: Panel; className: string }) {
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
  const layout = useLayout();
  const panel = activePanel(layout, panels, side);
  if (!layout.docks[side].open || !panel) return null;
  return <ShownDock side={side} panel={panel} size={layout.docks[side].size} />;
}

const kLoading = <p className="empty">Loading…</p>;

function ShownDock({ side, panel, size }: { side: DockName; panel: Panel; size: number }) {
  const { ui } = useSession();
  const Shown = panel.component;
  // The map comes first: what a panel lists may be long.
  const isDue = useDeferredValue(true, false);
  return (
    <section
      className={`dock ${side}`}
      style={side === "bottom" ? { height: size } : { width: size }}
      aria-label={panel.title}
    >
      <Splitter
        side={side}
        label={side === "bottom" ? "Height of the bottom panel" : `Width of the ${side} panel`}
        size={size}
        {...kDockSizes[side]}
        onSize={(size) => ui.set("layout", resizeDock(ui.get("layout"), side, size))}
      />
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
          <Suspense fallback={kLoading}>{isDue ? <Shown /> : kLoading}</Suspense>
        </ErrorFence>
      </section>
    </section>
  );
}
