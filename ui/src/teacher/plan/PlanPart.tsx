import { Printer, Save, Scissors } from "lucide-preact";
import { useRef } from "preact/hooks";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { LinkButton } from "../../kit/LinkButton";
import { Loaded } from "../../kit/requests/Loaded";
import { ClassChips } from "../../shell/ClassChips";
import { classroom, shownClass } from "../../shell/classroom";
import { usePrintedPage } from "../../shell/files/printed_page";
import { canPrint, printPage } from "../../shell/files/printing";
import { hashOf } from "../../shell/route";
import type { School } from "../school";
import { useTeacherLoaded } from "../useTeacherLoaded";
import { loadPlanClass } from "./open_for_class";
import { PlanTable } from "./PlanTable";
import { savePage } from "./page_file";

interface PlanPartProps {
  school: School;
}

/** The plan of a two-hour lesson: opens its activities for a class, links to the cards, can be printed. */
export function PlanPart({ school: { classes } }: PlanPartProps) {
  const { plan: labels } = texts.value;
  const page = useRef<HTMLDivElement>(null);
  usePrintedPage("plan");
  const shown = classes.length > 0 ? shownClass(classroom.value, classes, []) : null;
  const found = useTeacherLoaded(`${shown} ${language.value}`, () => loadPlanClass(shown));
  return (
    <div class="plan" ref={page} data-testid="plan">
      <h1>{labels.title}</h1>
      <p>{labels.about}</p>
      <PlanTools onSave={() => savePage(page.current, labels.title, labels.fileName)} />
      {shown ? (
        <ClassChips classes={classes} withNone={false} shown={shown} />
      ) : (
        <p class="teacher__hint">{labels.noClass}</p>
      )}
      <Loaded of={found}>
        {(inClass) => <PlanTable classroom={shown} found={inClass} reload={found.reload} />}
      </Loaded>
      <p>{labels.robots}</p>
      <p>{labels.roles}</p>
      <div class="plan__more">
        <Points {...labels.deaf} />
        <Points {...labels.projector} />
      </div>
    </div>
  );
}

function PlanTools({ onSave }: { onSave(): Promise<void> }) {
  const { plan: labels } = texts.value;
  return (
    <div class="plan__tools">
      <LinkButton
        kind="main"
        icon={Scissors}
        href={hashOf({ screen: "cards" })}
        testId="plan-cards"
      >
        {labels.links.cards}
      </LinkButton>
      {canPrint() && (
        <Button icon={Printer} testId="plan-print" onPress={printPage}>
          {labels.print}
        </Button>
      )}
      <Button icon={Save} tip={labels.saveHelp} testId="plan-save" onPress={onSave}>
        {labels.save}
      </Button>
    </div>
  );
}

interface PointsProps {
  title: string;
  points: readonly string[];
}

function Points({ title, points }: PointsProps) {
  return (
    <section class="plan__points">
      <h2>{title}</h2>
      <ul>
        {points.map((point) => (
          <li key={point}>{point}</li>
        ))}
      </ul>
    </section>
  );
}
