import type { Status_Vehicle_Battery } from "../../core/protocol.ts";
import { batteryTone, kBatteryOld, percent } from "./vehicle.ts";

const kWidth = 15; // of what can be filled

/** How full it is, as a picture; its number stands elsewhere. */
export function Battery({ battery }: { battery: Status_Vehicle_Battery }) {
  const isOld = battery.age > kBatteryOld;
  return (
    <svg
      className={`battery ${isOld ? "old" : batteryTone(battery)}`}
      viewBox="0 0 22 12"
      role="img"
      aria-label={`Battery ${percent(battery.share)} %`}
    >
      <rect className="battery-case" x="0.75" y="0.75" width="18.5" height="10.5" rx="2" />
      <path className="battery-pole" d="M21 4v4" />
      <rect x="2.5" y="2.5" width={Math.max(1, kWidth * battery.share)} height="7" rx="0.8" />
    </svg>
  );
}
