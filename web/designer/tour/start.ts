// The tour begins on an empty page: with a new configuration, unless the one that is shown is empty.
import type { Designer } from "../session/designer.ts";

export async function startTour(designer: Designer): Promise<void> {
  const { document } = designer;
  const isEmpty = document !== undefined && !document.isReadOnly && document.declarations.length === 0;
  if (!isEmpty && !(await designer.navigation.open("", ""))) return;
  designer.store.setState({ tour: 0, tourWaits: false });
  // What the first steps are about; in a narrow window the simulator has taken its room.
  if (!designer.state.shown.palette) designer.show({ palette: true, live: false });
}
