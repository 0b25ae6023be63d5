import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { typeWords } from "../drawing/value_words.ts";
import { isEquipment, lastPart } from "../session/pages.ts";
import { type Drawing, Drawing_Kind, type Parameter } from "../session/protocol.ts";
import { nameOf } from "../session/titles.ts";
import { useDesigner, useDocument, useIsReadOnly } from "../session/use.ts";
import { BindingDetails, EquipmentDetails } from "./equipment_details.tsx";
import { Heading, Section, SentText } from "./parts.tsx";
import { RobotDetails } from "./robot_details.tsx";
import { SocietyDetails } from "./society_details.tsx";

export function PageDetails({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const document = useDocument();
  const page = drawing.page?.path ?? "";
  const isDeclaration = page !== "" && !page.includes(".");
  const declaration = document?.declarations.find((one) => one.name === page);
  return (
    <div className="details">
      <Heading
        name={page !== "" ? lastPart(page) : document ? nameOf(document) : ""}
        kind={page === "" ? "configuration" : kindOf(drawing, declaration?.kind ?? "")}
      />
      {isDeclaration && (
        <SentText
          label="What it is for"
          value={drawing.help}
          send={(text) =>
            void designer.edit("change the documentation", { case: "setHelp", value: { page, node: "", text } })
          }
        />
      )}
      {page === "" && <FileSummary />}
      {drawing.robot && <RobotDetails robot={drawing.robot} name={page} />}
      {drawing.kind === Drawing_Kind.SOCIETY && <SocietyDetails drawing={drawing} />}
      {drawing.equipment && isEquipment(drawing) && (
        <EquipmentDetails drawing={drawing} equipment={drawing.equipment} />
      )}
      {drawing.equipment && drawing.kind === Drawing_Kind.BINDING && (
        <BindingDetails drawing={drawing} equipment={drawing.equipment} />
      )}
      {isDeclaration && !kWithoutParameters.has(drawing.kind) && <Parameters drawing={drawing} />}
    </div>
  );
}

const kWithoutParameters: ReadonlySet<Drawing_Kind> = new Set([Drawing_Kind.SOCIETY, Drawing_Kind.OPERATOR]);

function kindOf(drawing: Drawing, declared: string): string {
  if (drawing.kind === Drawing_Kind.STATES)
    return declared ? `${declared}, a sequence of states` : "a sequence of states";
  const gives = drawing.resultType ? `gives ${drawing.resultType}` : "";
  return [declared || "inside", gives].filter((part) => part !== "").join(", ");
}

function FileSummary() {
  const designer = useDesigner();
  const document = useDocument();
  const declarations = document?.declarations ?? [];
  if (declarations.length === 0) return <p className="small muted">It is empty: add an assemblage at the left.</p>;
  return (
    <Section title="Declarations">
      <ul>
        {declarations.map((one) => (
          <li key={`${one.kind} ${one.name}`} className="declaration">
            <Button tone="link" onPress={() => designer.navigation.goTo(document!.path, one.name)}>
              {one.name}
            </Button>
            <span className="small muted"> {one.kind}</span>
          </li>
        ))}
      </ul>
    </Section>
  );
}

function Parameters({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const isReadOnly = useIsReadOnly();
  const owner = drawing.page?.path ?? "";
  return (
    <Section
      title="Parameters"
      tools={
        !isReadOnly && (
          <IconButton
            icon="plus"
            label="Add a parameter"
            onPress={() => designer.store.setState({ dialog: "parameter", subject: "" })}
          />
        )
      }
    >
      {drawing.parameters.length === 0 && (
        <p className="small muted">None yet. “Make it a parameter” on an input makes one of it.</p>
      )}
      <ul className="inputs">
        {drawing.parameters.map((parameter) => (
          <li key={parameter.name} className="columns spread" style={{ flexWrap: "nowrap" }}>
            <Button
              tone="link"
              className="grow"
              isDisabled={isReadOnly}
              onPress={() => designer.store.setState({ dialog: "parameter", subject: parameter.name })}
            >
              <b>{parameter.name}</b> <span className="muted">{summary(parameter)}</span>
            </Button>
            {!isReadOnly && (
              <IconButton
                icon="close"
                label={`Remove ${parameter.name}`}
                onPress={() =>
                  void designer.edit(`remove parameter ${parameter.name}`, {
                    case: "removeParameter",
                    value: { owner, name: parameter.name },
                  })
                }
              />
            )}
          </li>
        ))}
      </ul>
    </Section>
  );
}

function summary(parameter: Parameter): string {
  const type = typeWords(parameter.type, parameter.unit);
  return parameter.initial ? `${type} = ${parameter.initial}` : type;
}
