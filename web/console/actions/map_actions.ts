// What is seen on the map, and the tools on it.
import { kLayers, type LayerName, withLayer } from "../../core/map_settings.ts";
import type { ActionRow } from "../../ui/commands/declared.ts";
import { tools } from "../extensions/extensions.ts";
import { copyPlace } from "../session/copy_place.ts";
import type { ActionTable, Tool } from "../session/registry.ts";
import type { Session } from "../session/session.ts";
import { noMap, onlyWatching } from "./hindrances.ts";

const kLayerKeys: { readonly [Layer in LayerName]?: string } = { trails: "t", vectors: "v" };

export const kMapTable: ActionTable = {
  group: "Map",
  rows: [
    {
      id: "fit",
      label: "Fit the whole map",
      icon: "fit",
      shortcut: "f",
      unless: [noMap],
      run: ({ ui }) => ui.get("map")?.framing.fit(),
    },
    {
      id: "zoom-in",
      label: "Zoom in",
      icon: "plus",
      shortcut: "+",
      unless: [noMap],
      run: ({ ui }) => ui.get("map")?.framing.zoom(Math.SQRT2),
    },
    {
      id: "zoom-out",
      label: "Zoom out",
      icon: "minus",
      shortcut: "-",
      unless: [noMap],
      run: ({ ui }) => ui.get("map")?.framing.zoom(Math.SQRT1_2),
    },
    {
      id: "military",
      label: ({ model }) => (model.get("map").military ? "Plain symbols" : "Military symbols"),
      shortcut: "shift+m",
      run: ({ model, ui }) => {
        const { military } = model.get("map");
        ui.editMap(military ? "plain symbols" : "military symbols", { military: !military });
      },
    },
    {
      id: "copy-place",
      label: "Copy the place under the pointer",
      icon: "copy",
      shortcut: "shift+c",
      unless: [({ ui }) => (ui.get("map")?.placeUnderPointer() ? undefined : "The pointer was not on the map yet.")],
      run: (session) => {
        const place = session.ui.get("map")?.placeUnderPointer();
        if (place) void copyPlace(session, place);
      },
    },
    ...kLayers.map(([layer, name]) => layerRow(layer, name)),
  ],
};

function layerRow(layer: LayerName, name: string): ActionRow<Session> {
  const isShown = ({ model }: Session) => model.get("map").layers[layer];
  const shortcut = kLayerKeys[layer];
  return {
    id: `layer-${layer}`,
    label: (session) => `${isShown(session) ? "Hide" : "Show"} ${name.toLowerCase()}`,
    ...(shortcut ? { shortcut } : {}),
    run: (session) => {
      const shown = isShown(session);
      const { layers } = withLayer(session.model.get("map"), layer, !shown);
      session.ui.editMap(`${shown ? "hide" : "show"} ${name.toLowerCase()}`, { layers });
    },
  };
}

export const kToolTable: ActionTable = {
  group: "Tools",
  rows: [
    {
      id: "tool-select",
      label: "Select and move about",
      icon: "pointer",
      shortcut: "s",
      run: ({ ui }) => ui.set("tool", ""),
    },
    ...tools.map(toolRow),
  ],
};

function toolRow({ id, label, icon, shortcut, forOperator }: Tool): ActionRow<Session> {
  return {
    id: `tool-${id}`,
    label,
    icon,
    ...(shortcut ? { shortcut } : {}),
    unless: forOperator ? [onlyWatching, noMap] : [noMap],
    run: ({ ui }) => ui.set("tool", ui.get("tool") === id ? "" : id),
  };
}
