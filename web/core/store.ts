// A record of named parts; who shows a part hears of its changes and of no others.

/** Parts are values that are replaced, never changed in place: a reader compares by identity. */
export class Store<Parts extends object> {
  private readonly listeners = new Map<keyof Parts, Set<() => void>>();

  constructor(private readonly parts: Parts) {}

  get<Name extends keyof Parts>(name: Name): Parts[Name] {
    return this.parts[name];
  }

  set<Name extends keyof Parts>(name: Name, value: Parts[Name]): void {
    if (Object.is(this.parts[name], value)) return;
    this.parts[name] = value;
    for (const listener of [...(this.listeners.get(name) ?? [])]) listener();
  }

  /** Returns how to end it: fits React's useSyncExternalStore. */
  subscribe(name: keyof Parts, listener: () => void): () => void {
    let known = this.listeners.get(name);
    if (!known) {
      known = new Set();
      this.listeners.set(name, known);
    }
    known.add(listener);
    return () => known.delete(listener);
  }
}
