/** The plan of a lesson of two hours, and the cards to cut out for it. docs/lesson.pt-BR.md says the same. */
export const plan = {
  title: "Aula de duas horas",
  about:
    "Dois períodos de 50 minutos, cinco grupos. Cada grupo programa a sua letra; no fim, um sinal faz o robô desenhá-la.",
  print: "Imprimir",
  save: "Salvar como arquivo",
  saveHelp: "Salva uma página que abre e imprime em qualquer navegador",
  fileName: "plano-de-aula",
  columns: {
    minutes: "min",
    teacher: "Professora ou professor",
    groups: "Grupos",
    screen: "Tela",
  },
  steps: {
    human: {
      minutes: "0–15",
      teacher: "“O robô aspirador obedece a quê?” Robô humano: só “andar 1”, “girar 90”.",
      groups: "Dão exemplos; ditam o caminho até a porta: ao girar, o robô não anda.",
      screen: "Exemplo Aspirador",
    },
    alphabet: {
      minutes: "15–25",
      teacher:
        "Alfabeto manual: A, B, E, L, S, T, de frente. Datilologia é soletrar com ele; não é o sinal da palavra.",
      groups: "Copiam em duplas.",
      screen: "Letras grandes",
    },
    first: {
      minutes: "25–35",
      teacher: "Passeio inicial e atividade 1.3.",
      groups: "Preveem, rodam, comparam.",
      screen: "Cartão, chão",
    },
    paper: {
      minutes: "35–50",
      teacher:
        "Dá papel e cartões recortados (andar, girar, repetir, caneta, ler sinal, se; o número se escreve a lápis).",
      groups: "Planejam a letra (2.6); um integrante faz o papel do robô e segue o plano.",
      screen: "Desligada",
    },
    blocks: {
      minutes: "50–70",
      teacher: "Circula: “Que bloco fez isso?”",
      groups: "Passam os cartões para blocos, rodam, trocam de papel.",
      screen: "Blocos e chão",
    },
    decide: {
      minutes: "70–75",
      teacher: "“Primeiro ler, depois decidir.”",
      groups: "Acrescentam “ler sinal” e “se”.",
      screen: "Atividade 3.1",
    },
    show: {
      minutes: "75–92",
      teacher: "Um grupo por vez: sinal, robô, a turma lê.",
      groups: "Explicam um conserto (“mais 10° no último giro”).",
      screen: "Robô ou projetor",
    },
    talk: {
      minutes: "92–100",
      teacher: "“Fechou? É simétrica? Voltou? O difícil: ângulo, distância, ordem, hora do sinal?”",
      groups: "Uma frase cada um.",
      screen: "Linhas da aula",
    },
  },
  robots:
    "Um robô de verdade: 3 min por grupo, fita de 1 m no chão, mão em Parar. Sem robô: o chão aparece no projetor.",
  deaf: {
    title: "Com alunos surdos",
    points: [
      "Tradutor-intérprete de Libras (TILS) e tela lado a lado; cada aluno vê o rosto de quem fala e o TILS; fala uma pessoa por vez.",
      "O roteiro da aula chega ao TILS dois dias antes. Sinais combinados antes: robô, girar, repetir, conserto.",
      "A luz fica acesa durante a projeção.",
      "Há tempo para olhar: ninguém olha para a tela e para o TILS ao mesmo tempo.",
      "O português escrito é segunda língua: frases inteiras e curtas, cartões com a mão desenhada.",
      "O que o robô diz fica escrito; apitar também pisca, e nenhuma pista é só sonora.",
      "O aluno surdo pode ensinar o alfabeto manual à turma, se quiser; não é tarefa dele interpretar para os colegas.",
    ],
  },
  projector: {
    title: "Um computador e projetor",
    points: [
      "Planos no papel.",
      "Um grupo monta, os outros preveem com os dedos (1–4).",
      "A cada 6 min troca, e o próximo conserta.",
    ],
  },
  roles:
    "Em cada grupo todos agem: piloto, leitor, fiscal do percurso, sinalizante. Trocam a cada dez minutos.",
  open: (activity: string) => `Abrir ${activity} para a turma`,
  isOpen: (activity: string) => `${activity} está aberta para a turma`,
  noClass: "Para abrir uma atividade daqui, crie antes uma turma.",
  links: {
    cards: "Cartões para recortar",
    letters: "Praticar letras e sinais",
    lessons: "Aulas",
  },
  cards: {
    title: "Cartões para recortar",
    about: "Blocos de verdade, com espaço para escrever os valores a lápis.",
    back: "Plano de aula",
    which: "Quais",
    lists: {
      lesson: "Da aula de duas horas",
      level1: "Nível 1",
      level2: "Nível 2",
      level3: "Nível 3: todos",
      letters: "Letras do alfabeto manual: A, B, E, L, S, T",
    },
    copies: "De cada um",
    ink: "Cor",
    inks: { lines: "Preto no branco", colours: "Em cores" },
    sheet: "Cartões",
    drawing: "Desenhando os cartões…",
    fileName: "cartoes",
    printHelp:
      "Folha A4. Se aqui não houver impressora, salve como arquivo e abra em um navegador de outro computador.",
  },
};
