// What the main button has to know, gathered from the model.
import type { Model } from "../../core/model.ts";
import { isOld } from "../vehicles/vehicle.ts";
import type { Situation } from "./main_button.ts";

export function situationOf(model: Model, isStarting = false): Situation {
  const status = model.get("status") ?? undefined;
  const plan = model.get("plan");
  const clients = model.get("clients");
  const documents = model.get("documents")?.documents ?? [];
  return {
    status,
    isOperator: model.isOperator(),
    isElsewhen: model.isElsewhen(),
    hasOperator: clients?.clients.some((client) => client.id === clients.operator) ?? false,
    isConnected: model.get("link").state === "open",
    openQuestions: model.get("questions").length,
    errors: documents.reduce((sum, document) => sum + document.diagnostics.filter((one) => !one.isWarning).length, 0),
    nextLabel: status ? (plan?.steps[status.currentStep]?.label ?? "") : "",
    whyNotStart: model.get("preflight")?.whyNotStart ?? "",
    isStarting,
    silentVehicles: status?.vehicles.filter(isOld).map(({ name }) => name) ?? [],
    hasVehicles: (status?.vehicles.length ?? 0) > 0,
    hasAsked: clients !== null && clients.asks !== 0 && clients.asks === model.get("welcome")?.client,
  };
}
