// How a vehicle is, in words: what it has said, and how old that is.
import {
  Status_Vehicle_Driver as Driver,
  Status_Vehicle_Readiness as Readiness,
  type Status,
  type Status_Vehicle,
  type Status_Vehicle_Battery,
  type Status_Vehicle_Sensor,
} from "../../core/protocol.ts";
import { count, distance, list, quantity } from "../../ui/words/format.ts";

export type Tone = "" | "go" | "hold" | "danger" | "accent";

/** What was said longer ago than this is grey: a vehicle speaks twenty times a second [s]. */
export const kOld = 2;
/** The same of its battery, of which vehicles speak less often; a failsafe takes it for empty then [s]. */
export const kBatteryOld = 10;

export function vehicleOf(status: Status | null, robot: number): Status_Vehicle | undefined {
  return status?.vehicles.find((one) => one.robot === robot);
}

/** Something has come from it. */
export function isHeard(vehicle: Status_Vehicle): boolean {
  return vehicle.readiness !== Readiness.UNHEARD;
}

export function isTaken(vehicle: Status_Vehicle): boolean {
  return vehicle.readiness === Readiness.TAKEN;
}

export function isOld(vehicle: Status_Vehicle): boolean {
  return !isHeard(vehicle) || vehicle.age > kOld;
}

/** The worst first; what is old is not known any more. */
export function condition(vehicle: Status_Vehicle): { word: string; tone: Tone } {
  if (vehicle.readiness === Readiness.UNHEARD) return { word: "Not heard yet", tone: "hold" };
  if (vehicle.age > kOld) return { word: `Silent for ${seconds(vehicle.age)}`, tone: "danger" };
  if (vehicle.isStopped) return { word: "Emergency stop", tone: "danger" };
  if (vehicle.readiness === Readiness.FAULTY) return { word: "Faulty", tone: "danger" };
  if (isTaken(vehicle)) return { word: "A pilot has it", tone: "hold" };
  if (vehicle.driver === Driver.ANOTHER_RUN) return { word: "Another run has it", tone: "hold" };
  if (vehicle.readiness === Readiness.STANDBY) return { word: "On standby", tone: "" };
  if (vehicle.readiness !== Readiness.IS_READY) return { word: "Not ready", tone: "hold" };
  return { word: "Ready", tone: "go" };
}

/** Why it would not do what its robot wants, or what holds it; empty: nothing does. */
export function whyNot(vehicle: Status_Vehicle): string {
  const parts = [
    vehicle.isStopped ? "an emergency stop holds there" : "",
    isTaken(vehicle) ? "a pilot, or somebody else, has taken it: it is left to them" : "",
    vehicle.why === "" ? "" : `it ${vehicle.why}`,
  ].filter((part) => part !== "");
  return list(parts);
}

/** `12 s`, `0.4 s`. */
export function seconds(value: number): string {
  return value < 10 ? `${value.toFixed(1)} s` : `${Math.floor(value)} s`;
}

/** `64 %, 24.6 V`; with its age where that is old. */
export function batteryText(battery: Status_Vehicle_Battery | undefined): string {
  if (!battery) return "it does not tell";
  const voltage = battery.voltage > 0 ? `, ${battery.voltage.toFixed(1)} V` : "";
  const age = battery.age > kBatteryOld ? `, as it was ${seconds(battery.age)} ago` : "";
  return `${percent(battery.share)} %${voltage}${age}`;
}

/** In whole per cent, and never more than there is. */
export function percent(share: number): number {
  return Math.floor(share * 100 + 1e-6);
}

/** Of a battery: nobody should have to compare numbers to see that it is nearly empty. */
export function batteryTone(battery: Status_Vehicle_Battery): Tone {
  if (battery.share < 0.15) return "danger";
  return battery.share < 0.3 ? "hold" : "go";
}

/** How old the newest report is, and how long a command takes to arrive and be answered. */
export function linkText(vehicle: Status_Vehicle): string {
  if (vehicle.readiness === Readiness.UNHEARD) return "nothing has come from it";
  const age = vehicle.age > kOld ? `nothing for ${seconds(vehicle.age)}` : `heard ${seconds(vehicle.age)} ago`;
  return vehicle.trip === undefined ? age : `${age}, ${seconds(vehicle.trip)} there and back`;
}

export function driverText(vehicle: Status_Vehicle): string {
  const { driver } = vehicle;
  if (isTaken(vehicle)) return "a pilot, or somebody else";
  if (driver === Driver.THIS_RUN) return "this run";
  return driver === Driver.ANOTHER_RUN ? "another run" : "nobody";
}

/** Whether it knows its place, and how old that is. */
export function placeText({ motionAge, isGlobal }: Status_Vehicle): string {
  if (motionAge === undefined) return "it does not say where it is";
  const how = isGlobal ? "known on the map" : "counted from its start";
  return motionAge > kOld ? `${how}, as it was ${seconds(motionAge)} ago` : how;
}

/** `360 rays to 12 m`, `24 cones of 30° to 10.7 m`. */
export function sensorText(sensor: Status_Vehicle_Sensor): string {
  const degrees = Math.round((sensor.beamWidth * 180) / Math.PI);
  const beams = count(sensor.beams, sensor.beamWidth > 0 ? "cone" : "ray");
  const width = degrees > 0 ? ` of ${degrees}°` : "";
  const age = sensor.age > kOld ? `, as it was ${seconds(sensor.age)} ago` : "";
  return `${beams}${width} to ${distance(sensor.farthest).replace(".0 m", " m")}${age}`;
}

/** Sensors that are alike are told once. */
export function sensorsText(vehicle: Status_Vehicle): string {
  if (vehicle.sensors.length === 0) return "none of distances";
  const counts = new Map<string, number>();
  for (const sensor of vehicle.sensors) {
    const text = sensorText(sensor);
    counts.set(text, (counts.get(text) ?? 0) + 1);
  }
  return [...counts].map(([text, n]) => (n > 1 ? `${quantity(n)} × ${text}` : text)).join("; ");
}

/** All of it in a line, for the list of robots and who can't see it. */
export function summary(vehicle: Status_Vehicle): string {
  const battery = vehicle.battery ? `, battery ${batteryText(vehicle.battery)}` : "";
  return `${vehicle.kind}: ${condition(vehicle).word.toLowerCase()}${battery}`;
}

/** Redrawn only where something of it reads otherwise. */
export function isSameVehicle(a: Status_Vehicle | undefined, b: Status_Vehicle | undefined): boolean {
  if (!a || !b) return a === b;
  return summary(a) === summary(b) && isOld(a) === isOld(b);
}
