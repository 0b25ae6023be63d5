// Drawing an overlay: a palette of control measures, what is being drawn, the selected one by numbers, all of them, the area.
import { useEffect, useMemo } from "react";
import { useStore } from "zustand";
import { type KindInfo, kindInfo, kindOfWire, kKinds, type MeasureKind } from "../../core/measure_kinds.ts";
import { Complete_Language, type Documents_Document } from "../../core/protocol.ts";
import { Button, Hint, Switch } from "../../ui/controls/controls.tsx";
import { NumberEntry } from "../../ui/controls/number_entry.tsx";
import { SelectEntry } from "../../ui/controls/select_entry.tsx";
import { editMap } from "../map_editing/edit_map.ts";
import { changeEditing, editStore } from "../map_editing/edit_store.ts";
import { type ListedThing, ThingList } from "../map_editing/thing_list.tsx";
import { useMayOrder, usePart, useSession, useUi } from "../session/session.ts";
import { type Draft, emptyDraft, guidance, missingInDraft } from "./draft.ts";
import { drawingStore } from "./drawing_store.ts";
import { KindIcon } from "./kind_icon.tsx";
import { MeasureForm } from "./measure_form.tsx";
import { proposeName } from "./names.ts";
import { NewOverlay } from "./new_overlay.tsx";
import { odlText } from "./odl_text.ts";
import "./overlay.css";
import { addMeasure, measureOfDraft } from "./scene_measures.ts";

export function OverlayPanel() {
  const scene = usePart("scene");
  const documents = usePart("documents")?.documents ?? [];
  const selection = usePart("selection");
  const overlays = documents.filter((d) => d.language === Complete_Language.OVERLAY);
  const [item, ...others] = selection.items;
  const index = item?.kind === "measure" && others.length === 0 ? item.index : -1;
  const measure = scene?.measures[index];

  if (!scene || overlays.length === 0) return <NewOverlay />;
  return (
    <div className="overlay">
      {measure && <MeasureForm key={index} index={index} wire={measure} />}
      <Palette />
      <Measures />
      <Area overlays={overlays} />
    </div>
  );
}

const kGroups: readonly KindInfo["group"][] = ["Places", "Lines", "Buildings"];

function Palette() {
  const { ui } = useSession();
  const mayOrder = useMayOrder();
  const tool = useUi("tool");
  const { kind } = useStore(editStore);
  const { draft } = useStore(drawingStore);
  const active = tool === "draw" ? kind : null;
  const take = (next: MeasureKind) => {
    ui.set("tool", "draw");
    // The tool is taken up first: it begins with nothing to draw.
    queueMicrotask(() => changeEditing({ kind: active === next ? null : next }));
  };
  return (
    <section aria-label="What to draw" className="rows">
      {kGroups.map((group) => (
        <div key={group} className="overlay-group">
          <h3>{group}</h3>
          <div className="overlay-kinds">
            {kKinds
              .filter((k) => k.group === group)
              .map((k) => (
                <Hint key={k.kind} text={k.purpose}>
                  <Button
                    className="overlay-kind"
                    aria-pressed={active === k.kind}
                    tone={active === k.kind ? "primary" : "plain"}
                    isDisabled={!mayOrder}
                    onPress={() => take(k.kind)}
                  >
                    <KindIcon kind={k.kind} />
                    <span>{k.label}</span>
                  </Button>
                </Hint>
              ))}
          </div>
        </div>
      ))}
      {active && <Drawing draft={draft ?? emptyDraft(active)} />}
    </section>
  );
}

/** What is being drawn: what to do next, and the text that it will be. */
function Drawing({ draft }: { draft: Draft }) {
  const session = useSession();
  const names = usePart("scene")?.measures.map((m) => m.name) ?? [];
  const info = kindInfo(draft.kind);
  const name = proposeName(draft.kind, names);
  const measure = measureOfDraft(draft, name);
  const lacks = missingInDraft(draft);
  const drop = () => {
    // As Enter on the map: a point, or a short line, in the middle of what is shown.
    const map = session.ui.get("map");
    const x = Math.round(map?.camera.x ?? 0);
    const y = Math.round(map?.camera.y ?? 0);
    const step = Math.max(1, Math.round(60 / (map?.camera.scale ?? 1)));
    const count = info.shape === "region" && info.minPoints === 1 ? 1 : info.minPoints;
    const points = [
      { x, y },
      { x: x + step, y },
      { x: x + step, y: y + step },
    ].slice(0, count);
    const made = measureOfDraft({ ...draft, points }, name);
    changeEditing({ kind: null });
    void editMap(session, `draw ${name}`, [addMeasure(made)], editStore.getState().document).then((done) => {
      if (done) drawingStore.setState({ naming: (session.model.get("scene")?.measures.length ?? 1) - 1 });
    });
  };
  return (
    <div className="notice overlay-drawing">
      <p role="status">
        <b>{info.label}.</b> {guidance(draft)}
      </p>
      {draft.points.length > 0 && <code>{odlText(measure)}</code>}
      {draft.points.length > 0 && lacks !== "" && <p>{lacks}</p>}
      <div className="columns">
        <Button onPress={drop}>Put it in the middle of the map</Button>
        <Button tone="quiet" onPress={() => changeEditing({ kind: null })}>
          Cancel
        </Button>
      </div>
    </div>
  );
}

function Measures() {
  const scene = usePart("scene");
  const things = useMemo(
    () =>
      (scene?.measures ?? []).map(
        (m, index): ListedThing => ({
          item: { kind: "measure", index },
          title: m.name || "without a name",
          detail: kindOfWire(m.kind)?.label ?? "",
          isEditable: m.document !== "",
        }),
      ),
    [scene],
  );
  return (
    <section aria-label="All control measures" className="rows overlay-all">
      <h3>Control measures</h3>
      <ThingList label="Control measures" things={things} />
    </section>
  );
}

function Area({ overlays }: { overlays: readonly Documents_Document[] }) {
  const session = useSession();
  const mayOrder = useMayOrder();
  const scene = usePart("scene");
  const { grid, document } = useStore(editStore);
  const present = overlays.some((d) => d.path === document);
  useEffect(() => {
    if (document !== "" && !present) changeEditing({ document: "" });
  }, [document, present]);
  if (!scene) return null;
  const setArea = (width: number, height: number) =>
    void editMap(
      session,
      "set the mission area",
      [{ change: { case: "setArea", value: { width, height } } }],
      document,
    );
  return (
    <section aria-label="The map" className="rows">
      <h3>Mission area</h3>
      <div className="world-fields">
        <NumberEntry
          label="Width, west to east [m]"
          value={scene.width}
          min={0.1}
          isDisabled={!mayOrder}
          onCommit={(width) => setArea(width, scene.height)}
        />
        <NumberEntry
          label="Height, south to north [m]"
          value={scene.height}
          min={0.1}
          isDisabled={!mayOrder}
          onCommit={(height) => setArea(scene.width, height)}
        />
      </div>
      {overlays.length > 1 && (
        <SelectEntry
          label="New things go to"
          value={document}
          choices={[
            ["", `${overlays[0]?.path} (the first)`],
            ...overlays.slice(1).map((d) => [d.path, d.path] as const),
          ]}
          onChange={(path) => changeEditing({ document: path })}
        />
      )}
      <Switch label="Snap to the grid" value={grid} onChange={(on) => changeEditing({ grid: on })} />
    </section>
  );
}
