// Plots of ports and quantities over time: a strip for each subject, all over one axis of time.
import { type KeyboardEvent, useCallback, useEffect, useMemo, useRef, useState } from "react";
import { Button, DialogTrigger, Menu, MenuItem, MenuTrigger, Popover, ToggleButton } from "react-aria-components";
import type uPlot from "uplot";
import { useStore } from "zustand";
import { useIsElsewhen, usePart, useSession } from "../session/session.ts";
import { useHasPast, useTravel, useWhereabouts } from "../time/use_travel.ts";
import { saveCsv, savePng, saveSvg } from "./downloads.ts";
import { type PlotState, plotStore } from "./plot_store.ts";
import { PlotStrip } from "./plot_strip.tsx";
import "./plots.css";
import { type Recorder, recorderOf } from "./recorder.ts";
import { type SeriesSpec, seriesKey } from "./series.ts";
import { SeriesChooser } from "./series_chooser.tsx";
import { kWindows, panSpan, type Strip, spanOf, spanRound, stripsOf, zoomSpan } from "./strips.ts";

const kColorsLight = ["#1d5fc4", "#b4540a", "#14713f", "#a3195b", "#6a4bc4", "#0b7285", "#7a6200", "#4d5766"];
const kColorsDark = ["#74a8ff", "#ff9f5a", "#5fd08c", "#ff85b8", "#b197fc", "#4fd1e0", "#e3c34e", "#c3ccd8"];

const change = (part: Partial<PlotState>) => plotStore.setState(part);
const zoom = (from: number, to: number) => change({ view: { live: false, from, to } });
const goLive = (window = plotStore.getState().window) => change({ window, view: { live: true, window } });

export function PlotsPanel() {
  const { model, connection } = useSession();
  const { specs, view } = useStore(plotStore);
  const theme = usePart("map").theme;
  const recorder = recorderOf(model, connection);
  const [cursor, setCursor] = useState<number | null>(null);
  const revision = useRevision(() => recorder.revision, specs.length > 16 ? 250 : 100);
  const plots = useRef(new Map<string, uPlot>());

  const travel = useTravel();
  const at = useWhereabouts();
  useEffect(() => recorder.record(specs), [recorder, specs]);
  usePastOf(recorder, specs);
  const strips = useStrips();
  const extent = recorder.extent();
  const span = at.isNow ? spanOf(view, extent.first, extent.last) : spanRound(view, at.time, travel.end);
  const colors = theme === "dark" ? kColorsDark : kColorsLight;
  const look = useMemo(lookOf, [theme]);

  const remove = (spec: SeriesSpec) => change({ specs: specs.filter((s) => seriesKey(s) !== seriesKey(spec)) });
  const onPlot = useCallback((key: string, plot: uPlot | null) => {
    if (plot) plots.current.set(key, plot);
    else plots.current.delete(key);
  }, []);
  const save = (kind: React.Key) => {
    const shown = { strips, recorder, span, colors, plots: plots.current };
    if (kind === "png") void savePng(shown);
    else if (kind === "svg") saveSvg(shown);
    else saveCsv(shown);
  };

  return (
    <div className="plots">
      <PlotsBar onHold={() => zoom(span.from, span.to)} onExport={save} />
      {strips.length === 0 ? (
        <NoPlots />
      ) : (
        <section
          className="plots-strips"
          aria-label="Plots; plus and minus zoom, arrow keys move, 0 goes back to live"
          // biome-ignore lint/a11y/noNoninteractiveTabindex: keys zoom while it has the focus, and it scrolls
          tabIndex={0}
          onKeyDown={(event) => press(event, span)}
        >
          {strips.map((strip) => (
            <PlotStrip
              key={strip.key}
              strip={strip}
              recorder={recorder}
              span={span}
              revision={revision}
              colors={colors}
              look={look}
              cursor={cursor}
              moment={at.isNow ? null : at.time}
              onGo={travel.does.go}
              onCursor={setCursor}
              onZoom={zoom}
              onReset={goLive}
              onRemove={remove}
              onPlot={onPlot}
            />
          ))}
        </section>
      )}
    </div>
  );
}

/** Over the whole run: read once all at once for what was chosen, and again after one has looked back. */
function usePastOf(recorder: Recorder, specs: readonly SeriesSpec[]): void {
  const { model } = useSession();
  const hasPast = useHasPast();
  const isElsewhen = useIsElsewhen();
  useEffect(
    () => (hasPast ? recorder.readPast(model, isElsewhen) : undefined),
    [recorder, model, hasPast, isElsewhen, specs],
  );
}

function useStrips(): Strip[] {
  const { specs, together } = useStore(plotStore);
  const roster = usePart("roster");
  return useMemo(() => {
    const portUnit = (robot: number, port: string) => roster.portsOf(robot).find((p) => p.path === port)?.unit ?? "";
    return stripsOf(specs, together, portUnit);
  }, [specs, together, roster]);
}

interface PlotsBarProps {
  /** Time stands still in the plots as they are. */
  onHold: () => void;
  onExport: (kind: React.Key) => void;
}

function PlotsBar({ onHold, onExport }: PlotsBarProps) {
  const { specs, together, view } = useStore(plotStore);
  return (
    <div className="plots-bar" role="toolbar" aria-label="Plots">
      <DialogTrigger>
        <Button className="button primary">Add…</Button>
        <SeriesChooser present={specs} onAdd={(more) => change({ specs: [...specs, ...more] })} />
      </DialogTrigger>
      <Spans />
      <ToggleButton
        className="button"
        isDisabled={specs.length === 0}
        isSelected={!view.live}
        onChange={(held) => (held ? onHold() : goLive())}
      >
        {view.live ? "Hold" : "Back to live"}
      </ToggleButton>
      <ToggleButton
        className="button quiet"
        isSelected={together}
        isDisabled={specs.length < 2}
        onChange={(on) => change({ together: on })}
      >
        Shared axes
      </ToggleButton>
      <span className="plots-fill" />
      <ExportMenu isDisabled={specs.length === 0} onExport={onExport} />
      <Button className="button quiet" isDisabled={specs.length === 0} onPress={() => change({ specs: [] })}>
        Clear
      </Button>
    </div>
  );
}

function Spans() {
  const { window: seconds, view } = useStore(plotStore);
  return (
    <fieldset className="segments plots-windows">
      <legend className="hidden-text">Span of time</legend>
      {kWindows.map((w) => (
        <ToggleButton
          key={w.seconds}
          className="button"
          isSelected={view.live && seconds === w.seconds}
          onChange={() => goLive(w.seconds)}
        >
          {w.label}
        </ToggleButton>
      ))}
    </fieldset>
  );
}

function ExportMenu({ isDisabled, onExport }: { isDisabled: boolean; onExport: (kind: React.Key) => void }) {
  return (
    <MenuTrigger>
      <Button className="button" isDisabled={isDisabled}>
        Export
      </Button>
      <Popover className="popover">
        <Menu className="menu" onAction={onExport}>
          <MenuItem className="menu-item" id="png">
            Picture (PNG)
          </MenuItem>
          <MenuItem className="menu-item" id="svg">
            Drawing (SVG)
          </MenuItem>
          <MenuItem className="menu-item" id="csv">
            Table (CSV)
          </MenuItem>
        </Menu>
      </Popover>
    </MenuTrigger>
  );
}

/** Nothing is plotted yet: what most people want is one press away. */
function NoPlots() {
  const roster = usePart("roster");
  const units = roster.units.filter((u) => u.parent < 0).slice(0, 4);
  const plot = (quantity: SeriesSpec["quantity"]) =>
    change({ specs: units.map((u) => ({ quantity, robot: 0, unit: u.name, port: "" })) });
  return (
    <div className="empty plots-none">
      <p>Any quantity, and any port of a robot’s program, over time.</p>
      {units.length > 0 && (
        <div className="columns">
          <Button className="button" onPress={() => plot("distance_to_goal")}>
            Distance to goal
          </Button>
          <Button className="button" onPress={() => plot("formation_error")}>
            Formation error
          </Button>
          <Button className="button" onPress={() => plot("speed")}>
            Speed
          </Button>
        </div>
      )}
    </div>
  );
}

function press(event: KeyboardEvent, span: { from: number; to: number }): void {
  const next = keyView(event.key, span);
  if (next === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  event.stopPropagation();
  if (next === null) goLive();
  else zoom(next.from, next.to);
}

/** undefined: the key means nothing here; null: back to live. */
function keyView(key: string, span: { from: number; to: number }): { from: number; to: number } | null | undefined {
  switch (key) {
    case "+":
    case "=":
      return zoomSpan(span, 0.5);
    case "-":
      return zoomSpan(span, 2);
    case "ArrowLeft":
      return panSpan(span, -0.1);
    case "ArrowRight":
      return panSpan(span, 0.1);
    case "0":
      return null;
    default:
      return undefined;
  }
}

/** The newest revision, looked at so often [ms]. */
function useRevision(read: () => number, interval: number): number {
  const [revision, setRevision] = useState(read);
  const latest = useRef(read);
  latest.current = read;
  useEffect(() => {
    const timer = setInterval(() => setRevision(latest.current()), interval);
    return () => clearInterval(timer);
  }, [interval]);
  return revision;
}

function lookOf(): { text: string; grid: string; past: string; font: string } {
  const style = getComputedStyle(document.documentElement);
  const read = (name: string, fallback: string) => style.getPropertyValue(name).trim() || fallback;
  return {
    text: read("--text-2", "#555"),
    grid: read("--line", "#ddd"),
    past: read("--past", "#6a3fb5"),
    font: `11px ${read("--font", "sans-serif")}`,
  };
}
