import { Button } from "../../ui/controls/controls.tsx";
import { replaceRobots } from "../session/orders.ts";
import { usePart, useSession } from "../session/session.ts";

/** For robots that stand because of a fault. */
export function ReplaceButton({ robots }: { robots: readonly number[] }) {
  const session = useSession();
  usePart("clients");
  const isOne = robots.length === 1;
  return (
    <div className="rows">
      <p className="muted">
        {isOne
          ? "Another robot of its type can take its place, under the same order: its program begins anew where it stands."
          : "Others of their types can take their places, under the same orders: their programs begin anew where they stand."}
      </p>
      <Button isDisabled={!session.model.isOperator()} onPress={() => void replaceRobots(session, robots)}>
        {isOne ? "Replace it" : `Replace these ${robots.length}`}
      </Button>
    </div>
  );
}
