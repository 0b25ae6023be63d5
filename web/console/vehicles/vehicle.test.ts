import { create, type Message, type MessageInitShape } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import {
  Status_Vehicle_Driver as Driver,
  Status_Vehicle_Readiness as Readiness,
  Status_VehicleSchema,
  StatusSchema,
} from "../../core/protocol.ts";
import {
  batteryText,
  batteryTone,
  condition,
  driverText,
  isOld,
  isSameVehicle,
  linkText,
  percent,
  placeText,
  sensorsText,
  summary,
  vehicleOf,
  whyNot,
} from "./vehicle.ts";

type Told = Exclude<MessageInitShape<typeof Status_VehicleSchema>, Message>;
const vehicle = (init: Told = {}) =>
  create(Status_VehicleSchema, {
    robot: 1,
    name: "veh-1",
    kind: "MAVLink rover at udp:14550",
    readiness: Readiness.IS_READY,
    age: 0.1,
    driver: Driver.THIS_RUN,
    isGlobal: true,
    motionAge: 0.1,
    battery: { share: 0.64, voltage: 24.58, age: 1 },
    ...init,
  });
const battery = (share: number, voltage = 0, age = 0) => vehicle({ battery: { share, voltage, age } }).battery;

describe("how a vehicle is", () => {
  it("is of the robot whose body it is", () => {
    const status = create(StatusSchema, { vehicles: [vehicle(), vehicle({ robot: 3, name: "veh-3" })] });
    expect(vehicleOf(status, 3)?.name).toBe("veh-3");
    expect(vehicleOf(status, 2)).toBeUndefined();
    expect(vehicleOf(null, 1)).toBeUndefined();
  });
  it("is the worst that is known of it", () => {
    const word = (init: Told) => condition(vehicle(init)).word;
    expect(word({})).toBe("Ready");
    expect(word({ readiness: Readiness.NOT_READY })).toBe("Not ready");
    expect(word({ readiness: Readiness.TAKEN })).toBe("A pilot has it");
    expect(word({ driver: Driver.ANOTHER_RUN })).toBe("Another run has it");
    expect(word({ readiness: Readiness.STANDBY })).toBe("On standby");
    expect(word({ readiness: Readiness.FAULTY })).toBe("Faulty");
    expect(word({ isStopped: true, readiness: Readiness.FAULTY })).toBe("Emergency stop");
    expect(word({ isStopped: true, age: 12.7 })).toBe("Silent for 12 s");
    expect(word({ readiness: Readiness.UNHEARD, age: 3 })).toBe("Not heard yet");
  });
  it("says why it would not move", () => {
    expect(whyNot(vehicle())).toBe("");
    expect(whyNot(vehicle({ why: "is not armed" }))).toBe("it is not armed");
    expect(whyNot(vehicle({ isStopped: true, why: "is in another mode: MANUAL" }))).toBe(
      "an emergency stop holds there and it is in another mode: MANUAL",
    );
  });
  it("is old when nothing was heard for two seconds, or ever", () => {
    expect([0.1, 2, 2.1].map((age) => isOld(vehicle({ age })))).toEqual([false, false, true]);
    expect(isOld(vehicle({ readiness: Readiness.UNHEARD, age: 0 }))).toBe(true);
  });
});

describe("what a vehicle has", () => {
  it("is told of its battery with volts and age where they say something", () => {
    expect(batteryText(vehicle().battery)).toBe("64 %, 24.6 V");
    expect(batteryText(battery(1))).toBe("100 %");
    expect(batteryText(battery(0.299, 11.1, 42))).toBe("29 %, 11.1 V, as it was 42 s ago");
    expect(batteryText(undefined)).toBe("it does not tell");
    expect([0, 0.29, 0.57, 1].map(percent)).toEqual([0, 29, 57, 100]);
    const tones = [0.14, 0.15, 0.29, 0.3].map((share) => {
      const told = battery(share);
      return told && batteryTone(told);
    });
    expect(tones).toEqual(["danger", "hold", "hold", "go"]);
  });
  it("is told of its link", () => {
    expect(linkText(vehicle())).toBe("heard 0.1 s ago");
    expect(linkText(vehicle({ trip: 0.3 }))).toBe("heard 0.1 s ago, 0.3 s there and back");
    expect(linkText(vehicle({ age: 31.9 }))).toBe("nothing for 31 s");
    expect(linkText(vehicle({ readiness: Readiness.UNHEARD }))).toBe("nothing has come from it");
    expect(driverText(vehicle())).toBe("this run");
    expect(driverText(vehicle({ readiness: Readiness.TAKEN }))).toBe("a pilot, or somebody else");
  });
  it("is told of its place and sensors, of those that are alike once", () => {
    expect(placeText(vehicle())).toBe("known on the map");
    expect(placeText(vehicle({ isGlobal: false, motionAge: 7 }))).toBe("counted from its start, as it was 7.0 s ago");
    expect(placeText({ ...vehicle(), motionAge: undefined })).toBe("it does not say where it is");
    const cone = { beams: 1, farthest: 10.7, beamWidth: Math.PI / 6 };
    const sensors = [{ beams: 360, farthest: 12 }, cone, { ...cone, number: 2 }];
    expect(sensorsText(vehicle({ sensors }))).toBe("360 rays to 12 m; 2 × 1 cone of 30° to 10.7 m");
    expect(sensorsText(vehicle())).toBe("none of distances");
  });
  it("fits in a line, which is all that the list redraws for", () => {
    expect(summary(vehicle())).toBe("MAVLink rover at udp:14550: ready, battery 64 %, 24.6 V");
    expect(isSameVehicle(vehicle(), vehicle({ age: 0.2, trip: 0.4 }))).toBe(true);
    expect(isSameVehicle(vehicle(), vehicle({ age: 4 }))).toBe(false);
    expect(isSameVehicle(vehicle(), undefined)).toBe(false);
    expect(isSameVehicle(undefined, undefined)).toBe(true);
  });
});
