\\ PARI/GP: roots of integer cubics by polroots, not certified. The work and the folder come from the environment.
{
  my(words = strsplit(getenv("PEERS_WORK"), "-"), wanted = eval(words[2]), family = words[3], read_numbers);
  my(name = Str(getenv("PEERS_FOLDER"), "/roots-", family), cubics, reference, rounds, start, found, worst = 0, least = oo);
  read_numbers = (file -> apply(line -> apply(eval, strsplit(line, " ")), readstr(file)));
  default(realprecision, wanted + 20);
  reference = apply(pair -> pair[1] + I*pair[2], read_numbers(Str(name, "-", wanted, ".txt")));
  cubics = apply(Polrev, read_numbers(Str(name, ".txt")))[1 .. #reference \ 3];
  \\ The clock counts milliseconds.
  rounds = if(wanted <= 100, 20, 10);
  default(realprecision, wanted);
  for(repetition = 1, 3,
    start = gettime();
    for(round = 1, rounds, found = apply(polroots, cubics));
    least = min(least, gettime()));
  default(realprecision, wanted + 20);
  for(i = 1, #cubics, for(j = 1, 3,
    worst = max(worst, vecmin(vector(3, k, abs(found[i][j]/reference[3*i - 3 + k] - 1))))));
  \\ Agreement in all digits is no more than the digits say.
  worst = max(worst, 10.^-wanted/100);
  start = floor(log(worst)/log(10));
  printf("row work=%s method=pari-polroots options=polroots;polynomials~ready tolerance=- items=%d seconds=%.6f error=%.2fe%d wrong=0 steps=- evaluations=-\n",
    getenv("PEERS_WORK"), rounds*#cubics, least/1000., worst/10.^start, start);
}
