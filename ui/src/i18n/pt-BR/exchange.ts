/** Work that goes from PC to PC. */
export const exchange = {
  title: "Pendrive e pasta da escola",
  intro:
    "Aqui os trabalhos de muitos computadores viram um só conjunto. Juntar duas vezes o mesmo arquivo não muda nada, e a ordem não importa.",
  places: "Onde estão os arquivos",
  lookAgain: "Procurar de novo",
  nowhere: "Nenhum pendrive encontrado.",
  nowhereHint:
    "Conecte um pendrive e espere um instante, ou escolha a pasta da escola aqui embaixo.",
  stick: (name: string) => `Pendrive ${name}`,
  folder: (name: string) => `Pasta ${name}`,
  free: (size: string) => `${size} livres`,
  readOnly: "só pode ser lido",
  unreachable: "não responde agora",
  noFiles: "Ainda sem arquivos do PINEL.",
  file: (size: string, when: string) => `${size} · ${when}`,
  nameless: "Sem nomes",
  doubles:
    "Este arquivo traz grupos chamados “Grupo 1”, “Grupo 2”… Se eles já estão aqui, aparecem duas vezes, e só dá para desfazer apagando para sempre.",
  cameNameless: "Vieram sem nomes: os grupos se chamam “Grupo 1”, “Grupo 2”…",
  choose: (name: string) => `Juntar ${name}`,
  merge: (n: number) => (n === 1 ? "Juntar 1 arquivo" : `Juntar ${n} arquivos`),
  merging: (n: number, of: number) => `Juntando ${n} de ${of}…`,
  saveHere: "Salvar os trabalhos",
  anonymous: "Sem nomes nem textos",
  anonymousHint: "Para mostrar a outros: não diz de quem é o trabalho.",
  saving: "Salvando…",
  what: "O que salvar",
  everything: "Tudo deste computador",
  onlyClass: (name: string) => `Só a turma ${name}`,
  saved: (name: string, groups: string, runs: string) => `Salvo em ${name}: ${groups} e ${runs}.`,
  takeOut: "Já pode tirar o pendrive.",
  saveIn: (folder: string) => `Salvar em “${folder}”`,
  results: "O que veio",
  brought: (computer: string, parts: string) => `${computer}: ${parts}.`,
  lessonCame: "Este é um arquivo de aula. Para abrir a aula aqui, vá a “Aulas”.",
  nothingNew: (computer: string) => `${computer}: nada de novo, já estava tudo aqui.`,
  nothingComes: (computer: string) => `${computer}: nada de novo.`,
  heldBack: (parts: string) => `Não volta, porque foi apagado para sempre: ${parts}.`,
  heldBackRest: "Uma parte deste arquivo não volta, porque foi apagada para sempre.",
  deleted: (parts: string) => `Apagado: ${parts}.`,
  deletedRest: "Apagado aqui também.",
  only: (computer: string) => `${computer}: nomes e ajustes atualizados.`,
  groups: (n: number) => (n === 1 ? "1 grupo" : `${n} grupos`),
  programs: (n: number) => (n === 1 ? "1 programa" : `${n} programas`),
  versions: (n: number) => (n === 1 ? "1 versão" : `${n} versões`),
  runs: (n: number) => (n === 1 ? "1 rodada" : `${n} rodadas`),
  heard: "Computadores com trabalhos já reunidos aqui",
  heardNobody: "Ainda não há trabalhos de outro computador.",
  computer: "Computador",
  exported: "Arquivo feito em",
  merged: "Juntado em",
  heardRuns: "Rodadas",
  clock: "As horas são as do relógio de cada computador, que pode estar errado.",
  shared: "Pasta da escola",
  sharedHint:
    "Uma pasta da rede ou deste computador que aparece aqui como um pendrive. Deixe vazio para não usar.",
  sharedExample: "Por exemplo: \\\\servidor\\robotica ou /rede/robotica",
  sharedSilent: {
    message: "A pasta da escola não responde agora.",
    remedy:
      "Ela continua escolhida. Confira se a rede está ligada ou se a pasta abre neste computador.",
  },
  sharedBackups: "Guardar ali também as cópias de segurança deste computador",
  sharedBackupsHint: "Quem pode ler essa pasta pode ler os trabalhos dos grupos.",
  keepShared: "Usar esta pasta",
  doomed: (computer: string, names: string, work: string) =>
    `Em ${computer} foi apagado para sempre: ${names} (aqui ainda há ${work}). Apagar aqui também? Não dá para desfazer.`,
  deleteToo: "Apagar aqui também",
  deleteRest: "Apagar o resto aqui também",
  undecided: {
    title: "Esperam a sua decisão",
    line: (computer: string, work: string) =>
      `Em ${computer} foi apagado para sempre o que aqui ainda há: ${work}.`,
    file: (name: string, when: string) => `Arquivo ${name}, ${when}`,
    ask: "Decidir agora",
  },
  whatToKeep:
    "Marque o que deve ficar, aqui e em todos os computadores. O que não está marcado se apaga:",
  programOf: (name: string, group: string) => `${name} (${group})`,
  isNow: (classroom: string) => `Está agora na turma ${classroom}.`,
  isNowWithout: "Está agora sem turma.",
  isNew: (parts: string) => `Mais novo aqui: ${parts}.`,
  edits: (n: number) => (n === 1 ? "1 mudança" : `${n} mudanças`),
  kept: (names: string) => `Mantido em todos os computadores: ${names}.`,
  keepHere: "Não apagar nada",
  unconfirmed: {
    came: "O trabalho está aqui; as atividades contam depois que o PINEL as conferir, o que ele faz sozinho.",
    waiting: (n: number) =>
      n === 1
        ? "1 rodada espera a conferência. O PINEL confere sozinho enquanto ninguém roda programas aqui."
        : `${n} rodadas esperam a conferência. O PINEL confere sozinho enquanto ninguém roda programas aqui.`,
    wrong: (n: number) =>
      n === 1
        ? "1 rodada não confere: repetida aqui, o resultado foi outro. A atividade dela não conta."
        : `${n} rodadas não conferem: repetidas aqui, o resultado foi outro. As atividades delas não contam.`,
    wrongWhere: "A página da aula mostra de que grupo.",
    notRepeatable: (n: number) =>
      n === 1
        ? "1 rodada não pode ser repetida aqui, por exemplo porque é de um robô de verdade. Ela conta se você a aceitar na página da aula."
        : `${n} rodadas não podem ser repetidas aqui, por exemplo porque são de um robô de verdade. Elas contam se você as aceitar na página da aula.`,
  },
  deletion: {
    title: "Apagar para sempre",
    hint: "Para quando uma turma se despede ou alguém pede que os seus dados sejam apagados. Tudo some deste computador e das cópias de segurança, e nenhum pendrive traz de volta.",
    what: "O que apagar",
    nothing: "Escolha um grupo ou a turma…",
    group: (name: string) => `O grupo ${name}`,
    classroom: (name: string) => `A turma ${name} inteira, com seus grupos`,
    goes: (name: string, programs: string, runs: string) =>
      `${name}: ${programs} e ${runs} serão apagados. Não dá para desfazer.`,
    go: "Apagar para sempre",
    cancel: "Deixar como está",
    done: (groups: string, programs: string, runs: string) =>
      `Apagado: ${groups}, ${programs}, ${runs}.`,
    left: "Apague também estes arquivos, que ainda podem conter esses trabalhos:",
  },
};
