// What is wrong with what is selected, beside its fields.
import { sentence, withoutBackticks } from "../../ui/words/sentence.ts";
import { useDocument, usePart } from "../session/use.ts";
import { Fixes } from "./fixes.tsx";

export function OwnProblems({ node }: { node: string }) {
  const document = useDocument();
  const page = usePart((state) => state.page);
  const own = (document?.problems ?? []).filter((problem) => problem.node === node && problem.page === page);
  if (own.length === 0) return null;
  return (
    <ul className="own-problems" aria-label={`What is wrong with ${node.includes("/") ? "the transition" : node}`}>
      {own.map((problem) => (
        <li
          key={`${problem.diagnostic?.begin} ${problem.diagnostic?.message}`}
          className={problem.diagnostic?.isWarning ? "small warning" : "small"}
        >
          <span>
            {sentence(problem.diagnostic?.message ?? "", withoutBackticks)}{" "}
            {(problem.diagnostic?.hints ?? []).map((hint) => sentence(hint, withoutBackticks)).join(" ")}
          </span>
          <Fixes problem={problem} />
        </li>
      ))}
    </ul>
  );
}
