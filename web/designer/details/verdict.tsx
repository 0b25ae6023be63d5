import { Icon } from "../../ui/controls/icons.tsx";

/** Whether something fits; where it does not, why. */
export function Verdict({ text, good }: { text: string; good: string }) {
  return (
    <span className={`verdict ${text === "" ? "good" : "bad"}`}>
      <Icon name={text === "" ? "check" : "warning"} />
      {text || good}
    </span>
  );
}
