import { Button } from "../../ui/controls/controls.tsx";
import { replaceRobots } from "../session/orders.ts";
import { usePart, useSession } from "../session/session.ts";

/** For robots that stand because of a fault. */
export function ReplaceButton({ robots }: { robots: readonly number[] }) {
  const session = useSession();
  usePart("clients");
  const roster = usePart("roster");
  const [first] = robots;
  const one = robots.length === 1 && first !== undefined ? roster.nameOf(first) : undefined;
  return (
    <div className="rows">
      <p className="muted">
        {one
          ? `Another robot of its type can take the place of ${one}, under the same order: its program begins anew there.`
          : "Others of their types can take their places, under the same orders: their programs begin anew there."}
      </p>
      <Button isDisabled={!session.model.mayOrder()} onPress={() => void replaceRobots(session, robots)}>
        {one ? `Replace ${one}` : `Replace these ${robots.length}`}
      </Button>
    </div>
  );
}
