// Before vehicles move: what was looked at, what a person confirms, and who signs.
import { useState } from "react";
import { Checkbox } from "react-aria-components";
import {
  type Preflight,
  type Preflight_Item,
  type Preflight_Manual,
  Preflight_Result as Result,
} from "../../core/protocol.ts";
import { Button, Field } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { order } from "../session/orders.ts";
import { usePart, useSession, useWhyNoOrder } from "../session/session.ts";
import {
  type Draft,
  failedIn,
  type Group,
  groupsOf,
  kBlank,
  missingIn,
  orderOf,
  resultWord,
  tally,
} from "./checklist.ts";
import "./preflight.css";

export function PreflightPanel() {
  const checklist = usePart("preflight");
  const roster = usePart("roster");
  if (!checklist?.hasVehicles) {
    return (
      <div className="empty">
        <p>This mission has no vehicles.</p>
        <p className="small">
          A vehicle is the host of its robot's type, in a run with a fleet. Nothing is signed for robots that are
          simulated.
        </p>
      </div>
    );
  }
  const groups = groupsOf(checklist, (robot) => roster.nameOf(robot));
  return (
    <div className="rows tab-body preflight">
      <Standing checklist={checklist} />
      {groups.map((group) => (
        <GroupItems key={group.key} group={group} isKnown={checklist.lookedAt > 0} />
      ))}
      {checklist.isNeeded && checklist.signedBy === "" && <ToSign checklist={checklist} />}
    </div>
  );
}

/** In a sentence or two: may it start? */
function Standing({ checklist }: { checklist: Preflight }) {
  const session = useSession();
  const isLooking = checklist.isLooking && checklist.lookedAt === 0;
  return (
    <section className="preflight-standing" aria-label="How it stands">
      <StandingNotice checklist={checklist} />
      <div className="columns spread">
        <span className="small muted number">
          {isLooking ? "Looking at the vehicles…" : `${tally(checklist.items)}, ${clock(checklist.lookedAt)}`}
        </span>
        <Button
          icon="cycle"
          isDisabled={checklist.isLooking && checklist.lookedAt === 0}
          onPress={() => void order(session, { case: "checkVehicles", value: {} })}
        >
          Look again
        </Button>
      </div>
    </section>
  );
}

function StandingNotice({ checklist }: { checklist: Preflight }) {
  if (checklist.unchecked !== "")
    return <p className="notice hold">Nothing has to be signed in this run. {sentence(checklist.unchecked)}</p>;
  if (checklist.lookedAt > 0 && !checklist.isNeeded)
    return <p className="notice">All vehicles are simulated: nothing real moves, so nobody has to sign.</p>;
  if (checklist.signedBy !== "") return <Signed checklist={checklist} />;
  return (
    <p className="notice hold">
      The mission moves vehicles. It starts once this checklist is signed. {sentence(checklist.whyNotStart)}
    </p>
  );
}

function Signed({ checklist }: { checklist: Preflight }) {
  return (
    <div className="notice go preflight-signed" data-testid="signed">
      <p>
        Signed by <strong>{checklist.signedBy}</strong> {clock(checklist.signedAt)}. The mission may start.
      </p>
      {checklist.accepted.map(({ item, because }) => (
        <p key={item}>
          {item} has failed, and was accepted: {sentence(because)}
        </p>
      ))}
    </div>
  );
}

function GroupItems({ group, isKnown }: { group: Group; isKnown: boolean }) {
  const title = `preflight-${group.key || "mission"}`;
  return (
    <section aria-labelledby={title}>
      <header className="preflight-head">
        <h3 id={title}>{group.title}</h3>
        {isKnown && group.items.length > 0 && <Pill result={group.worst} />}
      </header>
      {group.about !== "" && <p className="small muted preflight-about">{group.about}</p>}
      <ul className="preflight-items">
        {group.items.map((item) => (
          <ItemRow key={item.id} item={item} />
        ))}
      </ul>
    </section>
  );
}

function ItemRow({ item }: { item: Preflight_Item }) {
  return (
    <li className={`preflight-item ${resultWord(item.result).tone}`} data-testid={`item-${item.id}`}>
      <span className="preflight-name">{item.name}</span>
      <span className="preflight-is">
        {item.is}
        {item.expected !== "" && item.result !== Result.PASS && (
          <span className="muted preflight-expected">Expected: {item.expected}</span>
        )}
      </span>
      <Pill result={item.result} />
    </li>
  );
}

function Pill({ result }: { result: Result }) {
  const { word, tone } = resultWord(result);
  return <span className={`pill ${tone}`}>{word}</span>;
}

function ToSign({ checklist }: { checklist: Preflight }) {
  const session = useSession();
  const [draft, setDraft] = useState<Draft>({ ...kBlank, by: session.ui.get("name") });
  const [isSigning, setSigning] = useState(false);
  const why = useWhyNoOrder("sign");
  const missing = missingIn(checklist, draft);
  const sign = async () => {
    setSigning(true);
    await order(session, { case: "signPreflight", value: orderOf(checklist, draft) });
    setSigning(false);
  };
  return (
    <section className="preflight-sign" aria-label="Sign">
      <h3>At the vehicles</h3>
      <p className="small muted">What no instrument sees. Tick what you have seen to yourself.</p>
      {checklist.manual.map((item) => (
        <Confirm key={item.id} item={item} draft={draft} onChange={setDraft} />
      ))}
      {failedIn(checklist).map((item) => (
        <Field
          key={item.id}
          label={`${item.vehicle === "" ? "The mission" : item.vehicle}, ${item.name} has failed: why start all the same?`}
          value={draft.because[item.id] ?? ""}
          onChange={(text) => setDraft({ ...draft, because: { ...draft.because, [item.id]: text } })}
        />
      ))}
      <Field label="Your name" value={draft.by} onChange={(by) => setDraft({ ...draft, by })} />
      <Button
        tone="primary"
        className="large"
        icon="check"
        isDisabled={why !== undefined || missing.length > 0 || isSigning}
        onPress={() => void sign()}
      >
        {isSigning ? "Signing…" : "Sign"}
      </Button>
      {why !== undefined ? (
        <p className="small muted">{why}</p>
      ) : (
        missing.length > 0 && (
          <ul className="small muted preflight-missing">
            {missing.map((line) => (
              <li key={line}>{line}</li>
            ))}
          </ul>
        )
      )}
      <p className="small muted">A signature holds for an hour, for these texts and these vehicles.</p>
    </section>
  );
}

function Confirm({
  item,
  draft,
  onChange,
}: {
  item: Preflight_Manual;
  draft: Draft;
  onChange: (draft: Draft) => void;
}) {
  const change = (isConfirmed: boolean) => {
    const confirmed = new Set(draft.confirmed);
    if (isConfirmed) confirmed.add(item.id);
    else confirmed.delete(item.id);
    onChange({ ...draft, confirmed });
  };
  return (
    <Checkbox className="preflight-tick" isSelected={draft.confirmed.has(item.id)} onChange={change}>
      <span className="preflight-box">
        <Icon name="check" />
      </span>
      <span>{sentence(item.text)}</span>
    </Checkbox>
  );
}

/** `at 14:03:12`, by this machine's clock. */
function clock(seconds: number): string {
  return `at ${new Date(seconds * 1000).toLocaleTimeString([], { hour12: false })}`;
}
