// What is selected: one robot, several, a unit, or a thing on the map.
import { type ReactNode, useState } from "react";
import { Tab, TabList, TabPanel, Tabs } from "react-aria-components";
import { kNothing, selectUnit } from "../../core/selection.ts";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { count } from "../../ui/words/format.ts";
import { useSilence } from "../robots/state_pill.tsx";
import { usePart, useSession, useUi } from "../session/session.ts";
import { GroupFacts } from "./group_facts.tsx";
import { MapItemFacts } from "./map_item_facts.tsx";
import { ParametersTab } from "./parameters_tab.tsx";
import { PortsTab } from "./ports_tab.tsx";
import { RobotFacts } from "./robot_facts.tsx";
import { StatesOverTime } from "./states_over_time.tsx";
import { WhyTab } from "./why_tab.tsx";
import "./selection.css";

export function SelectionPanel() {
  const selection = usePart("selection");
  const roster = usePart("roster");
  const [tab, setTab] = useState("overview");
  const [first] = selection.robots;
  if (first === undefined) {
    const [item] = selection.items;
    return item ? <MapItemFacts item={item} others={selection.items.length - 1} /> : <NothingSelected />;
  }
  const isOne = selection.robots.length === 1 && selection.unit === "";
  return (
    <>
      <Heading />
      <Tabs className="tabs-box" selectedKey={tab} onSelectionChange={(key) => setTab(String(key))}>
        <TabList className="tab-list" aria-label="What to see">
          <Tab id="overview" className="tab">
            Overview
          </Tab>
          <Tab id="why" className="tab">
            Why?
          </Tab>
          <Tab id="parameters" className="tab">
            Parameters
          </Tab>
          <Tab id="ports" className="tab">
            Ports
          </Tab>
        </TabList>
        <TabPanel id="overview" className="tab-panel">
          {isOne ? (
            <>
              <RobotFacts id={first} />
              <StatesOverTime robot={first} />
            </>
          ) : (
            <GroupFacts robots={selection.robots} unit={selection.unit} />
          )}
        </TabPanel>
        <TabPanel id="why" className="tab-panel">
          <FirstOfSeveral robots={selection.robots} />
          <AsOld robot={first}>
            <WhyTab id={first} />
          </AsOld>
        </TabPanel>
        <TabPanel id="parameters" className="tab-panel">
          <ParametersTab key={roster.robot(first)?.program} robots={selection.robots} />
        </TabPanel>
        <TabPanel id="ports" className="tab-panel">
          <FirstOfSeveral robots={selection.robots} />
          <AsOld robot={first}>
            <PortsTab id={first} />
          </AsOld>
        </TabPanel>
      </Tabs>
    </>
  );
}

function NothingSelected() {
  return (
    <div className="empty">
      <p>Nothing is selected.</p>
      <p className="small">
        Click a robot on the map or in the Robots panel. A double click selects its unit, a frame drawn over empty
        ground all in it.
      </p>
    </div>
  );
}

function Heading() {
  const { model, ui } = useSession();
  const selection = usePart("selection");
  const roster = usePart("roster");
  useUi("map");
  const [first] = selection.robots;
  if (first === undefined) return null;
  const robot = roster.robot(first);
  const isOne = selection.robots.length === 1 && selection.unit === "";
  const title = selection.unit
    ? `Unit ${selection.unit}`
    : isOne
      ? roster.nameOf(first)
      : count(selection.robots.length, "robot");
  return (
    <header className="selection-head">
      {isOne && <span className="swatch large" style={{ background: robot?.color || "gray" }} />}
      <div className="selection-title">
        <h3 className="ellipsis">{title}</h3>
        {isOne && robot?.unit && (
          <Button tone="link" onPress={() => model.select(selectUnit(robot.unit, roster.robotsOf(robot.unit)))}>
            {robot.unit}
          </Button>
        )}
      </div>
      <IconButton
        icon="centre"
        label="Show on the map"
        shortcut="."
        onPress={() => ui.get("map")?.framing.fitSelection()}
      />
      <IconButton
        icon="follow"
        label="Follow"
        shortcut="Shift F"
        onPress={() => ui.get("map")?.framing.follow(selection.unit ? { unit: selection.unit } : { robot: first })}
      />
      <IconButton icon="close" label="Clear the selection" shortcut="Esc" onPress={() => model.select(kNothing)} />
    </header>
  );
}

/** Values of a robot, which are grey and say how old they are where nothing is heard of its machine. */
function AsOld({ robot, children }: { robot: number; children: ReactNode }) {
  const silence = useSilence(robot);
  return (
    <>
      {silence && <p className="as-old small">{silence.title}.</p>}
      <div className={silence ? "old-values" : ""}>{children}</div>
    </>
  );
}

/** With several selected, this tab tells of the first; another is a click away. */
function FirstOfSeveral({ robots }: { robots: readonly number[] }) {
  const { model } = useSession();
  const selection = usePart("selection");
  const roster = usePart("roster");
  if (robots.length < 2) return null;
  const [first] = robots;
  const turn = () => model.select({ ...selection, robots: [...robots.slice(1), first as number] });
  return (
    <div className="one-of small">
      <span>
        Of {roster.nameOf(first as number)}, one of {robots.length}.
      </span>
      <Button tone="link" onPress={turn}>
        <Icon name="right" /> The next
      </Button>
    </div>
  );
}
