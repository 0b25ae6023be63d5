// In the list of robots: that this one is real, and how full its battery is.
import { Icon } from "../../ui/controls/icons.tsx";
import { useReading } from "../session/session.ts";
import { Battery } from "./battery.tsx";
import { condition, isHeard, isOld, isSameVehicle, percent, seconds, summary, vehicleOf } from "./vehicle.ts";
import "./vehicles.css";

export function VehicleMark({ robot }: { robot: number }) {
  const vehicle = useReading(["status"], (model) => vehicleOf(model.get("status"), robot), isSameVehicle);
  if (!vehicle) return null;
  const { tone } = condition(vehicle);
  const text = summary(vehicle);
  return (
    <span className={`vehicle-mark ${isOld(vehicle) ? "old" : ""}`} title={text}>
      <span className={`vehicle-sign ${tone}`} role="img" aria-label={`A vehicle: ${text}`}>
        <Icon name="vehicle" />
      </span>
      {vehicle.battery && <Battery battery={vehicle.battery} />}
      {isOld(vehicle) ? (
        <span className="small number vehicle-age">{isHeard(vehicle) ? seconds(vehicle.age) : "–"}</span>
      ) : (
        vehicle.battery && <span className="small number vehicle-share">{percent(vehicle.battery.share)} %</span>
      )}
    </span>
  );
}
