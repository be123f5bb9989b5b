import {
  ChevronDown,
  ChevronUp,
  CircleCheck,
  Columns2,
  Flag,
  GitFork,
  Pencil,
  Play,
  SlidersHorizontal,
} from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import type { VersionSummary } from "../api/model";

import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { LinkButton } from "../kit/LinkButton";
import { hashOf } from "../shell/route";
import { program } from "../shell/session";
import type { VersionHistory } from "./history";
import { type Fork, faceOf, type Section, type VersionStep } from "./line";
import { setupFacts } from "./setup_texts";
import { changesIn, sectionText, spanOf, stepText } from "./version_texts";

/** The versions by lesson and day, with bursts of edits folded into one entry. */
export function VersionList({ history }: { history: VersionHistory }) {
  const list = useRef<HTMLElement>(null);
  const id = history.chosen.value?.id;
  useEffect(() => {
    list.current?.querySelector('[aria-current="true"]')?.scrollIntoView({ block: "nearest" });
  }, [id]);
  return (
    <nav class="line-list" aria-label={texts.value.archive.line} ref={list} data-scrolls>
      {history.sections.value.map((section) => (
        <SectionOf key={section.from} section={section} history={history} />
      ))}
    </nav>
  );
}

function SectionOf({ section, history }: { section: Section; history: VersionHistory }) {
  return (
    <section>
      <h2 class="line-list__day">
        {sectionText(section, new Date(), language.value, texts.value)}
      </h2>
      <ol>
        {section.items.map((item) =>
          item.kind === "step" ? (
            <StepOf key={faceOf(item).id} step={item} history={history} />
          ) : (
            <ForkOf
              key={item.branches[0]?.steps[0]?.versions[0]?.id}
              fork={item}
              history={history}
            />
          ),
        )}
      </ol>
    </section>
  );
}

function ForkOf({ fork, history }: { fork: Fork; history: VersionHistory }) {
  const labels = texts.value.archive;
  return (
    <li class="line-list__fork" data-testid="version-fork">
      <p class="line-list__fork-words row gap-2">
        <GitFork class="icon" aria-hidden="true" />
        <span>
          <strong>{labels.forkTitle({ n: fork.branches.length })}</strong> {labels.forkKept}
        </span>
      </p>
      <CompareBranches fork={fork} />
      <div class="line-list__branches">
        {fork.branches.map((branch) => (
          <section
            key={branch.steps[0]?.versions[0]?.id}
            class="line-list__branch"
            data-testid="version-branch"
          >
            <h3>{branch.computer ?? labels.unknownComputer}</h3>
            <ol>
              {branch.steps.map((step) => (
                <StepOf key={faceOf(step).id} step={step} history={history} />
              ))}
            </ol>
          </section>
        ))}
      </div>
    </li>
  );
}

/** Compares the newest versions of the first two branches, side by side. */
function CompareBranches({ fork }: { fork: Fork }) {
  const [before, after] = fork.branches.map(({ steps }) => steps.at(-1)).map((s) => s && faceOf(s));
  if (!before || !after || !program.value) return null;
  return (
    <LinkButton
      icon={Columns2}
      class="line-list__compare"
      href={hashOf({
        screen: "differences",
        program: program.value.id,
        before: before.id,
        after: after.id,
      })}
      testId="version-compare-fork"
    >
      {texts.value.archive.compareBranches}
    </LinkButton>
  );
}

function StepOf({ step, history }: { step: VersionStep; history: VersionHistory }) {
  const labels = texts.value.archive;
  const face = faceOf(step);
  const { versions } = step;
  const open = history.isUnfolded(step);
  const UnfoldIcon = open ? ChevronUp : ChevronDown;
  if (versions.length === 1) return <VersionRow version={face} step={step} history={history} />;
  return (
    <>
      <li class="row">
        <VersionButton
          version={face}
          step={step}
          history={history}
          current={!open && history.holdsChosen(step)}
        />
        <Button
          icon={UnfoldIcon}
          label={open ? labels.foldAgain : labels.showEach({ n: versions.length })}
          kind="plain"
          testId="version-unfold"
          open={open}
          onPress={() => history.fold(step)}
        />
      </li>
      {open &&
        versions.map((version) => (
          <VersionRow
            key={version.id}
            version={version}
            step={{ kind: "step", versions: [version] }}
            history={history}
            inner
          />
        ))}
    </>
  );
}

interface VersionRowProps {
  version: VersionSummary;
  step: VersionStep;
  history: VersionHistory;
  inner?: boolean;
}

function VersionRow({ inner = false, ...line }: VersionRowProps) {
  const current = line.history.chosen.value?.id === line.version.id;
  return (
    <li class={inner ? "line-list__inner" : ""}>
      <VersionButton {...line} current={current} />
    </li>
  );
}

function VersionButton({
  version,
  step,
  history,
  current,
}: VersionRowProps & { current: boolean }) {
  const first = step.versions[0] ?? version;
  const before = history.lineBefore(first) ?? first;
  const setup = setupFacts(before, version, texts.value, language.value);
  const { label, facts } = stepText(step, setup, texts.value);
  const times = spanOf(first.created_at, version.created_at, language.value);
  return (
    <Button
      icon={iconOf(step)}
      kind="bare"
      class={`line-list__step row middle grows shrinks gap-3 line-list__step--${toneOf(version)}`}
      current={current}
      testId="version-step"
      data-number={version.number}
      data-n={step.versions.length}
      onPress={() => history.choose(version)}
    >
      <span class="line-list__words shrinks">
        <strong>{label}</strong>
        <span>
          {[texts.value.archive.version({ n: version.number }), times, ...facts].join(" · ")}
        </span>
      </span>
    </Button>
  );
}

function iconOf(step: VersionStep) {
  const { label, n_passed, n_runs } = faceOf(step);
  if (n_passed > 0) return CircleCheck;
  if (label) return Flag;
  if (n_runs > 0) return Play;
  return changesIn(step) > 0 ? Pencil : SlidersHorizontal;
}

function toneOf({ label, n_passed, n_runs }: VersionSummary): string {
  if (n_passed > 0) return "passed";
  if (label) return "named";
  return n_runs > 0 ? "ran" : "plain";
}
