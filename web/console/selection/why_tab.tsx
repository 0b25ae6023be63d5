// Why it moves as it does: what it follows, what each schema contributes, what it waits for.

import { Bar } from "../../ui/controls/controls.tsx";
import { FactList } from "../../ui/controls/fact_list.tsx";
import { quantity, readableMessage } from "../../ui/words/format.ts";
import { usePart } from "../session/session.ts";
import { useMissing } from "./use_missing.ts";
import { direction, type Member, type VectorSum, vectorSums } from "./why.ts";

export function WhyTab({ id }: { id: number }) {
  const detail = usePart("details").get(id);
  const theme = usePart("map").theme;
  const missing = useMissing();
  if (!detail) return <p className="empty">{missing}</p>;
  const all = vectorSums(detail.contributions);
  return (
    <div className="rows tab-body">
      <FactList
        rows={[
          ["Follows", detail.command || "no command"],
          ["With assemblage", detail.task || "–"],
          ["In state", detail.states.length > 0 ? detail.states.join(", ") : "–"],
        ]}
      />
      <section aria-label="What the robot waits for">
        <h3>Waits for</h3>
        {detail.waitsFor.length === 0 && <p className="muted">Nothing.</p>}
        <ul className="why-waits">
          {detail.waitsFor.map((text) => (
            <li key={text}>{readableMessage(text)}</li>
          ))}
        </ul>
      </section>
      {all.length === 0 && <p className="notice">No schema contributes to its movement now.</p>}
      {all.map((sum) => (
        <Sum key={sum.name} sum={sum} isDark={theme === "dark"} />
      ))}
    </div>
  );
}

const kLightColors = ["#c2255c", "#1971c2", "#2b8a3e", "#9c36b5", "#a85a00", "#0c8599", "#5f3dc4", "#6b7000"];
const kDarkColors = ["#ff8fb1", "#74c0fc", "#8ce99a", "#e599f7", "#ffc078", "#66d9e8", "#b197fc", "#d8e06a"];

/** To a thousandth of full strength: what is less is nothing. */
function strength(share: number): string {
  return quantity(Math.round(share * 1000) / 1000 + 0, 3);
}

function Sum({ sum, isDark }: { sum: VectorSum; isDark: boolean }) {
  const colors = isDark ? kDarkColors : kLightColors;
  const colorOf = (i: number) => colors[i % colors.length] as string;
  const most = Math.max(sum.size, ...sum.members.map((member) => member.size));
  return (
    <section className="why-sum" aria-label={`Sum ${sum.name}`}>
      <h3 className="mono">{sum.name}</h3>
      <div className="why-picture">
        <Arrows sum={sum} colorOf={colorOf} />
        <p>
          Moves <strong>{direction(sum.x, sum.y)}</strong>
          <br />
          <span className="number muted small">
            strength {strength(sum.size)}
            <br />({strength(sum.x)} ahead, {strength(sum.y)} left)
          </span>
        </p>
      </div>
      <ul className="why-members">
        {sum.members.map((member, i) => (
          <MemberRow key={member.name} member={member} color={colorOf(i)} share={most > 0 ? member.size / most : 0} />
        ))}
      </ul>
    </section>
  );
}

function MemberRow({ member, color, share }: { member: Member; color: string; share: number }) {
  const effect = { with: "drives it", against: "holds against", across: "turns it aside", none: "silent" }[
    member.effect
  ];
  return (
    <li className={member.effect === "none" ? "muted" : ""}>
      <div className="columns spread" style={{ gap: 4 }}>
        <span className="columns" style={{ gap: 6 }}>
          <span className="swatch" style={{ background: color }} />
          {member.name}
        </span>
        <span className="number">{strength(member.size)}</span>
      </div>
      <Bar share={share} tone={color} />
      <span className="small muted number">
        {effect}
        {member.effect === "none"
          ? ""
          : ` · ${direction(member.x, member.y)} (${strength(member.x)}, ${strength(member.y)})`}
      </span>
    </li>
  );
}

/** Robot frame: ahead is up, left is left. */
function Arrows({ sum, colorOf }: { sum: VectorSum; colorOf: (i: number) => string }) {
  const most = Math.max(1e-6, sum.size, ...sum.members.map((member) => member.size));
  const reach = 46 / most;
  const end = (x: number, y: number) => ({ x: 60 - y * reach, y: 60 - x * reach });
  return (
    <svg
      className="why-arrows"
      viewBox="0 0 120 120"
      role="img"
      aria-label={`Contributions to ${sum.name}; the sum points ${direction(sum.x, sum.y)}`}
    >
      <circle cx="60" cy="60" r="50" className="why-ring" />
      <path d="M60 46 L67 68 L60 63 L53 68 Z" className="why-robot" />
      {sum.members.map((member, i) => (
        <Arrow key={member.name} {...end(member.x, member.y)} color={colorOf(i)} width={2} />
      ))}
      <Arrow {...end(sum.x, sum.y)} color="var(--text)" width={3} />
    </svg>
  );
}

function Arrow({ x, y, color, width }: { x: number; y: number; color: string; width: number }) {
  const length = Math.hypot(x - 60, y - 60);
  if (length < 1.5) return null;
  const angle = Math.atan2(y - 60, x - 60);
  const head = Math.min(8, length);
  const wing = (turn: number) => `${x - head * Math.cos(angle + turn)},${y - head * Math.sin(angle + turn)}`;
  return (
    <g stroke={color} fill={color} strokeWidth={width}>
      <line x1="60" y1="60" x2={x} y2={y} />
      <polygon points={`${x},${y} ${wing(0.42)} ${wing(-0.42)}`} strokeWidth="0.5" />
    </g>
  );
}
