// What is known of the vehicle that is a robot's body.
import { FactList } from "../../ui/controls/fact_list.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { usePart } from "../session/session.ts";
import { Battery } from "./battery.tsx";
import {
  batteryText,
  condition,
  driverText,
  isOld,
  linkText,
  placeText,
  sensorsText,
  vehicleOf,
  whyNot,
} from "./vehicle.ts";
import "./vehicles.css";

/** Nothing of a robot whose body is made up. */
export function VehicleFacts({ robot }: { robot: number }) {
  const vehicle = vehicleOf(usePart("status"), robot);
  if (!vehicle) return null;
  const { word, tone } = condition(vehicle);
  const why = whyNot(vehicle);
  return (
    <section className={`vehicle ${isOld(vehicle) ? "old" : ""}`} aria-label="Vehicle" data-testid="vehicle">
      <header className="vehicle-head">
        <h3>Vehicle {vehicle.name}</h3>
        <span className={`pill ${tone}`}>{word}</span>
      </header>
      {vehicle.kind !== vehicle.name && <p className="vehicle-kind">{vehicle.kind}</p>}
      {why !== "" && <p className={`notice ${tone === "danger" ? "danger" : "hold"}`}>{sentence(why)}</p>}
      <FactList
        rows={[
          [
            "Battery",
            <span className="vehicle-battery" key="battery">
              {vehicle.battery && <Battery battery={vehicle.battery} />}
              {batteryText(vehicle.battery)}
            </span>,
          ],
          ["Link", linkText(vehicle)],
          ["Driven by", driverText(vehicle)],
          ["Place", placeText(vehicle)],
          ["Sensors", sensorsText(vehicle)],
        ]}
      />
      {vehicle.heldBack !== "" && <p className="small muted">{sentence(vehicle.heldBack)}</p>}
    </section>
  );
}
