// What to plot, and of whom: two lists with search; each combination becomes a line.
import { useMemo, useState } from "react";
import {
  Button,
  Dialog,
  Heading,
  Input,
  Label,
  ListBox,
  ListBoxItem,
  Modal,
  ModalOverlay,
  SearchField,
  type Selection,
} from "react-aria-components";
import { kNone } from "../../core/protocol.ts";
import type { RosterIndex } from "../../core/roster.ts";
import type { Selection as MapSelection } from "../../core/selection.ts";
import { usePart } from "../session/session.ts";
import { type CatalogPort, type CatalogRoster, searchEntries, seriesFor, subjectsOf, whoOf } from "./catalog.ts";
import { kMostSeries } from "./recorder.ts";
import type { SeriesSpec } from "./series.ts";

interface Props {
  present: readonly SeriesSpec[];
  onAdd: (more: readonly SeriesSpec[]) => void;
}

const kMostShown = 200; // entries of a list; search reaches the others

export function SeriesChooser(props: Props) {
  return (
    <ModalOverlay className="scrim" isDismissable>
      <Modal className="dialog plots-chooser">
        <Dialog>{({ close }) => <Chooser {...props} close={close} />}</Dialog>
      </Modal>
    </ModalOverlay>
  );
}

function Chooser({ present, onAdd, close }: Props & { close: () => void }) {
  const index = usePart("roster");
  const selection = usePart("selection");
  const roster = useMemo(() => catalogRoster(index), [index]);
  const subjects = useMemo(() => subjectsOf(roster), [roster]);
  const people = useMemo(() => whoOf(roster), [roster]);
  const [subjectKeys, setSubjectKeys] = useState<ReadonlySet<string>>(new Set());
  const [whoKeys, setWhoKeys] = useState<ReadonlySet<string>>(() => new Set(firstWho(selection, index)));

  const more = seriesFor(
    roster,
    subjects.filter((s) => subjectKeys.has(s.key)),
    people.filter((w) => whoKeys.has(w.key)),
    present,
  );
  const room = kMostSeries - present.length;
  return (
    <>
      <header>
        <Heading slot="title">Add to the plots</Heading>
      </header>
      <div className="body plots-columns">
        <Pick
          label="What"
          placeholder="distance, gain, avoid …"
          entries={subjects}
          chosen={subjectKeys}
          onChosen={setSubjectKeys}
          lineOf={(s) => [s.unit === "" ? s.label : `${s.label} [${s.unit}]`, s.help]}
        />
        <Pick
          label="Of whom"
          placeholder="robot 3, scouts …"
          entries={people}
          chosen={whoKeys}
          onChosen={setWhoKeys}
          lineOf={(w) => [w.label, w.detail]}
        />
      </div>
      <footer>
        <span className="plots-count" role="status">
          {countText(subjectKeys.size, whoKeys.size, more.length, room)}
        </span>
        <Button className="button" onPress={close}>
          Cancel
        </Button>
        <Button
          className="button primary"
          isDisabled={more.length === 0 || room <= 0}
          onPress={() => {
            onAdd(more.slice(0, room));
            close();
          }}
        >
          Add
        </Button>
      </footer>
    </>
  );
}

interface PickProps<T> {
  label: string;
  placeholder: string;
  entries: readonly T[];
  chosen: ReadonlySet<string>;
  onChosen: (keys: ReadonlySet<string>) => void;
  lineOf: (entry: T) => readonly [string, string];
}

function Pick<T extends { key: string }>({ label, placeholder, entries, chosen, onChosen, lineOf }: PickProps<T>) {
  const [query, setQuery] = useState("");
  const found = useMemo(() => searchEntries(entries, query, lineOf), [entries, query, lineOf]);
  const shown = found.slice(0, kMostShown);
  // Entries that the search hides stay chosen.
  const choose = (keys: Selection) => {
    const visible = new Set(shown.map((e) => e.key));
    const now = keys === "all" ? shown.map((e) => e.key) : [...keys].map(String);
    onChosen(new Set([...[...chosen].filter((k) => !visible.has(k)), ...now]));
  };
  return (
    <div className="plots-pick">
      <SearchField className="field" value={query} onChange={setQuery}>
        <Label>{label}</Label>
        <Input className="input" placeholder={placeholder} />
      </SearchField>
      <ListBox
        className="plots-list"
        aria-label={label}
        items={shown}
        selectionMode="multiple"
        selectedKeys={chosen}
        onSelectionChange={choose}
        renderEmptyState={() => <span className="muted">Nothing of that name.</span>}
        dependencies={[lineOf]}
      >
        {(entry) => {
          const [text, detail] = lineOf(entry);
          return (
            <ListBoxItem id={entry.key} textValue={text} className="plots-entry">
              <span>{text}</span>
              {detail !== "" && <small>{detail}</small>}
            </ListBoxItem>
          );
        }}
      </ListBox>
      {found.length > shown.length && (
        <span className="help">… and {found.length - shown.length} more: search for them.</span>
      )}
    </div>
  );
}

function countText(subjects: number, people: number, more: number, room: number): string {
  if (subjects === 0) return "Choose what to plot.";
  if (people === 0) return "Choose of whom.";
  if (more === 0) return "These have nothing of that, or it is plotted already.";
  if (more > room) return `${more} lines; ${Math.max(room, 0)} have room, of ${kMostSeries} in all.`;
  return more === 1 ? "1 line" : `${more} lines`;
}

/** What is selected on the map, else the units that are in no other. */
function firstWho(selection: MapSelection, roster: RosterIndex): string[] {
  if (selection.unit !== "") return [`u:${selection.unit}`];
  if (selection.robots.length > 0) return selection.robots.slice(0, 16).map((id) => `r${id}`);
  return roster.units.filter((u) => u.parent < 0).map((u) => `u:${u.name}`);
}

/** Programs are told apart by their ports, once each. */
function catalogRoster(index: RosterIndex): CatalogRoster {
  const programs = new Map<number, { name: string; ports: readonly CatalogPort[] }>();
  for (const robot of index.robots) {
    if (robot.program === kNone || programs.has(robot.program)) continue;
    programs.set(robot.program, { name: index.programOf(robot.id), ports: index.portsOf(robot.id) });
  }
  const last = Math.max(-1, ...programs.keys());
  return {
    robots: index.robots,
    units: index.units.map((u) => ({ name: u.name, members: index.robotsOf(u.name) })),
    programs: Array.from({ length: last + 1 }, (_, i) => programs.get(i) ?? { name: "", ports: [] }),
  };
}
