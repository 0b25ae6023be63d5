/** Heads of transitions. */
export function Markers() {
  return (
    <svg className="markers" aria-hidden="true">
      <defs>
        {["arrow", "arrow-strong", "arrow-live"].map((id) => (
          <marker
            key={id}
            id={id}
            viewBox="0 0 10 10"
            refX="9"
            refY="5"
            markerWidth="9"
            markerHeight="9"
            markerUnits="userSpaceOnUse"
            orient="auto-start-reverse"
          >
            <path d="M0 0L10 5L0 10z" />
          </marker>
        ))}
      </defs>
    </svg>
  );
}
