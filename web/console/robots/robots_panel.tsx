// Units and robots: to search, select, centre and follow; what the map shows, for those who can't see it.
import { useMemo, useState } from "react";
import { Button as AriaButton, GridList, GridListItem, ListLayout, Virtualizer } from "react-aria-components";
import type { Selection } from "../../core/selection.ts";
import { Button, Search } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { count } from "../../ui/words/format.ts";
import { commandOfUnit, type Followed, followedBy, isSameFollowing } from "../mission/unit_command.ts";
import { usePart, useReading, useSession } from "../session/session.ts";
import { VehicleMark } from "../vehicles/vehicle_mark.tsx";
import { type RosterRow, rosterRows, selectedKeys, selectionOf } from "./rows.ts";
import { StatePill } from "./state_pill.tsx";
import "./robots.css";

export function RobotsPanel() {
  const { model, ui } = useSession();
  const roster = usePart("roster");
  const selection = usePart("selection");
  const [query, setQuery] = useState("");
  const [folded, setFolded] = useState<ReadonlySet<string>>(new Set());
  const followed = useReading(
    ["status", "roster"],
    (model) => followedBy(model.get("status"), (unit) => model.get("roster").robotsOf(unit)),
    isSameFollowing,
  );
  const rows = useMemo(() => rosterRows(roster, query, folded), [roster, query, folded]);
  const select = (next: Selection) => model.select(next);
  const fold = (unit: string) => {
    const next = new Set(folded);
    if (!next.delete(unit)) next.add(unit);
    setFolded(next);
  };
  return (
    <div className="robots">
      <div className="robots-bar">
        <Search label="Find a robot or unit" value={query} onChange={setQuery} />
        <span className="small muted number">{count(roster.robots.length, "robot")}</span>
      </div>
      <Virtualizer layout={ListLayout} layoutOptions={{ rowHeight: 32 }}>
        <GridList
          aria-label="Robots and units"
          className="robots-list"
          selectionMode="multiple"
          selectionBehavior="replace"
          selectedKeys={selectedKeys(selection)}
          onSelectionChange={(keys) =>
            select(selectionOf(keys === "all" ? rows.map((row) => row.key) : [...keys].map(String), roster))
          }
          onAction={() => ui.get("map")?.framing.fitSelection()}
          items={rows.map((row) => ({
            id: row.key,
            row,
            isFolded: row.kind === "unit" && folded.has(row.name),
            followed: row.kind === "robot" ? followed.get(row.id) : undefined,
          }))}
          renderEmptyState={() => (
            <p className="empty small">
              {roster.robots.length === 0 ? "This mission has no robots." : "Nothing is called that."}
            </p>
          )}
        >
          {({ id, row, isFolded, followed }) => (
            <GridListItem id={id} className="robot-row" textValue={row.name}>
              {row.kind === "unit" ? (
                <UnitRow row={row} isFolded={isFolded} onFold={() => fold(row.name)} />
              ) : (
                <RobotRow row={row} followed={followed} />
              )}
            </GridListItem>
          )}
        </GridList>
      </Virtualizer>
      <p className="robots-foot small muted">Click selects, double click or Enter shows it on the map.</p>
    </div>
  );
}

function UnitRow({
  row,
  isFolded,
  onFold,
}: {
  row: Extract<RosterRow, { kind: "unit" }>;
  isFolded: boolean;
  onFold: () => void;
}) {
  const { ui } = useSession();
  const command = useReading(["status"], (model) => commandOfUnit(model.get("status"), row.name));
  return (
    <span className="robot-cells" style={{ paddingLeft: row.depth * 16 }}>
      <Button
        tone="quiet"
        className={`square fold ${isFolded ? "" : "open"}`}
        aria-label={`${isFolded ? "Unfold" : "Fold"} ${row.name}`}
        onPress={onFold}
      >
        <Icon name="right" />
      </Button>
      <strong className="ellipsis">{row.name}</strong>
      <span className="small muted number">{row.robots.length}</span>
      <span className="small muted ellipsis grow">{command}</span>
      <AriaButton
        className="button quiet square"
        aria-label={`Follow ${row.name}`}
        onPress={() => ui.get("map")?.framing.follow({ unit: row.name })}
      >
        <Icon name="follow" />
      </AriaButton>
    </span>
  );
}

function RobotRow({ row, followed }: { row: Extract<RosterRow, { kind: "robot" }>; followed: Followed | undefined }) {
  const { model, ui } = useSession();
  const roster = model.get("roster");
  const color = roster.robot(row.id)?.color || "gray";
  return (
    <span className="robot-cells" style={{ paddingLeft: row.depth * 16 + 8 }}>
      <span className="swatch" style={{ background: color }} />
      <span className="ellipsis">{row.name}</span>
      <VehicleMark robot={row.id} />
      {followed && (
        <span className="small muted ellipsis grow robot-follows" title={`Follows ${followed.unit} ${followed.order}`}>
          {followed.unit === `robot ${row.id}` || roster.robotsOf(followed.unit).includes(row.id)
            ? ""
            : `${followed.unit}: `}
          {followed.order}
        </span>
      )}
      <Facts id={row.id} />
      <AriaButton
        className="button quiet square"
        aria-label={`Show ${row.name} on the map`}
        onPress={() => {
          const place = model.placeOf(row.id);
          if (place) ui.get("map")?.framing.centreOn(place);
        }}
      >
        <Icon name="centre" />
      </AriaButton>
      <AriaButton
        className="button quiet square"
        aria-label={`Follow ${row.name}`}
        onPress={() => ui.get("map")?.framing.follow({ robot: row.id })}
      >
        <Icon name="follow" />
      </AriaButton>
    </span>
  );
}

/** Redrawn by itself, some times a second. */
function Facts({ id }: { id: number }) {
  const { model } = useSession();
  usePart("time");
  const place = model.get("starts").rowOf(id) < 0 ? model.placeOf(id) : undefined;
  return (
    <>
      <span className="small muted number grow robot-place">
        {place ? `${Math.round(place.x)}, ${Math.round(place.y)}` : ""}
      </span>
      <StatePill robot={id} />
    </>
  );
}
