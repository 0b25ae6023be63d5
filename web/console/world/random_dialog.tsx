// Obstacles at random: how many, how large, from which seed, and what that comes to.
import { useState } from "react";
import { Button, Field, RangeSlider, Switch } from "../../ui/controls/controls.tsx";
import { DialogBox } from "../../ui/controls/menus.tsx";
import { count } from "../../ui/words/format.ts";
import { order } from "../map_editing/edit_map.ts";
import { usePart, useSession } from "../session/session.ts";
import {
  defaultRandomObstacles,
  expectedCount,
  problemsOf,
  type RandomObstacles,
  seedFrom,
} from "./random_obstacles.ts";

export function RandomObstaclesDialog({ onClose }: { onClose: () => void }) {
  const session = useSession();
  const scene = usePart("scene");
  const area = { width: scene?.width ?? 0, height: scene?.height ?? 0 };
  const [settings, setSettings] = useState<RandomObstacles>(() => ({
    ...defaultRandomObstacles(area),
    seed: freshSeed(),
  }));
  const [texts, setTexts] = useState(() => textsOf(settings));
  const standing = scene?.obstacles.map((o) => o.radius) ?? [];
  const number = expectedCount(settings, area, standing);
  const { errors, warnings } = problemsOf(settings, area, number);

  const type = (name: keyof typeof texts) => (text: string) => {
    setTexts({ ...texts, [name]: text });
    setSettings({ ...settings, [name]: text.trim() === "" ? Number.NaN : Number(text.replace(",", ".")) });
  };
  const change = (part: Partial<RandomObstacles>) => {
    const next = { ...settings, ...part };
    setSettings(next);
    setTexts(textsOf(next));
  };
  const create = async () => {
    const { coverage, minRadius, maxRadius, seed, replace } = settings;
    const value = { coveragePercent: coverage, minRadius, maxRadius, seed, replace };
    if (await order(session, { case: "createObstacles", value }, "create obstacles")) onClose();
  };

  return (
    <DialogBox
      title="Random obstacles"
      width={480}
      onClose={onClose}
      footer={
        <>
          <Button onPress={onClose}>Cancel</Button>
          <Button tone="primary" isDisabled={errors.length > 0} onPress={create}>
            {settings.replace ? "Replace obstacles" : "Add obstacles"}
          </Button>
        </>
      }
    >
      <RangeSlider
        label="Coverage of the area"
        value={Number.isFinite(settings.coverage) ? settings.coverage : 0}
        min={0}
        max={30}
        step={0.5}
        shown={`${settings.coverage} %`}
        onChange={(coverage) => change({ coverage })}
      />
      <div className="world-fields">
        <Field label="Smallest radius [m]" value={texts.minRadius} onChange={type("minRadius")} inputMode="decimal" />
        <Field label="Largest radius [m]" value={texts.maxRadius} onChange={type("maxRadius")} inputMode="decimal" />
        <Field
          label="Seed"
          value={texts.seed}
          onChange={type("seed")}
          inputMode="numeric"
          help="The same seed gives the same obstacles."
        />
        <Button className="world-randomize" onPress={() => change({ seed: freshSeed() })}>
          Randomize
        </Button>
      </div>
      <Switch
        label={`Take away the ${standing.length} that stand`}
        value={settings.replace}
        onChange={(replace) => change({ replace })}
      />
      <p role="status" className={errors.length > 0 ? "notice danger" : warnings.length > 0 ? "notice hold" : "notice"}>
        {errors.length > 0 ? errors.join(" ") : [`About ${count(number, "obstacle")}.`, ...warnings].join(" ")}
      </p>
    </DialogBox>
  );
}

function freshSeed(): number {
  return seedFrom(crypto.getRandomValues(new Uint32Array(1))[0] as number);
}

function textsOf({ minRadius, maxRadius, seed }: RandomObstacles) {
  return { minRadius: shown(minRadius), maxRadius: shown(maxRadius), seed: shown(seed) };
}

function shown(value: number): string {
  return Number.isNaN(value) ? "" : String(Math.round(value * 1000) / 1000);
}
