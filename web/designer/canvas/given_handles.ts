// Where wires end is known before a node is drawn (`handles`, from form.ts), and stays so: React Flow would measure what it
// finds in the page, which from far away is a block without any, and never look again.
import type { InternalNode, ReactFlowState, useStoreApi } from "@xyflow/react";
import { useState } from "react";

type Store = ReturnType<typeof useStoreApi>;
type Updates = Parameters<ReactFlowState["updateNodeInternals"]>[0];

/** Of nodes that come with their handles nothing is measured. Called before the first node is drawn. */
export function useGivenHandles(store: Store): void {
  useState(() => {
    const measure = store.getState().updateNodeInternals;
    store.setState({
      updateNodeInternals: (updates, options) => {
        const unknown = unmeasured(updates, store.getState().nodeLookup);
        if (unknown.size > 0) measure(unknown, options);
      },
    });
  });
}

export function unmeasured(updates: Updates, nodes: ReadonlyMap<string, InternalNode>): Updates {
  return new Map([...updates].filter(([id]) => !nodes.get(id)?.internals.userNode.handles));
}
