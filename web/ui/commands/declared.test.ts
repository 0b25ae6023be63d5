import { expect, test } from "vitest";
import { type ActionTable, actionsOf } from "./declared.ts";

interface Lamp {
  isOn: boolean;
  hasPower: boolean;
}

const kTable: ActionTable<Lamp, "Light"> = {
  group: "Light",
  rows: [
    {
      id: "switch",
      label: ({ isOn }) => (isOn ? "Off" : "On"),
      icon: "sun",
      shortcut: "l",
      unless: [
        ({ hasPower }) => (hasPower ? undefined : "There is no power."),
        ({ isOn }) => (isOn ? "It has to cool down." : undefined),
      ],
      run: (lamp) => {
        lamp.isOn = !lamp.isOn;
      },
    },
    { id: "look", label: "Look", run: () => {} },
  ],
};

test("a row's words follow how things stand", () => {
  const label = (isOn: boolean) => actionsOf(kTable, { isOn, hasPower: true })[0]?.label;
  expect([label(true), label(false)]).toEqual(["Off", "On"]);
});

test("the first hindrance that has something to say is told", () => {
  const blocked = (lamp: Lamp) => actionsOf(kTable, lamp)[0]?.blocked;
  expect(blocked({ isOn: true, hasPower: false })).toBe("There is no power.");
  expect(blocked({ isOn: true, hasPower: true })).toBe("It has to cool down.");
  expect(blocked({ isOn: false, hasPower: true })).toBeUndefined();
});

test("what is done is done to what it was listed for", () => {
  const lamp = { isOn: false, hasPower: true };
  const [first, second] = actionsOf(kTable, lamp);
  first?.run();
  expect(lamp.isOn).toBe(true);
  expect(first).toMatchObject({ id: "switch", group: "Light", icon: "sun", shortcut: "l" });
  expect(second).not.toHaveProperty("shortcut");
});
